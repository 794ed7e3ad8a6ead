// The smallest form of a look that shader code can hold within a stated error.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/engine/inline_look.h"
#include "lutlib/metrics/compare.h"

#include <optional>

namespace lutlib {

/// Nodes per axis and entries of a curve, at most: code is no place for more.
inline constexpr int most_inline_nodes = 17, most_inline_entries = 257;

struct InlineFit {
    InlineLook look;
    Difference error;
};

struct InlineSearch {
    std::optional<InlineFit> found; ///< within the bound
    InlineFit closest;              ///< of all that were tried
};

/// A table with a shaper and a cube, and how that is read.
struct ShapedTable {
    const Lut& table;
    Interpolation how;
};

/// Tries curves, curves with a matrix, and lattices, those of few numbers first, until the largest
/// dE2000 of one over the domain is within the bound; before them, of a look that is a `shaped`
/// table, its shaper with lattices of up to as many nodes as its own.
InlineSearch fit_inline(const Transform& look, const Domain& domain, const Breaks& breaks,
                        const LookEncodings& encodings, const Viewing& viewing, double max_delta_e,
                        const std::optional<ShapedTable>& shaped = std::nullopt);

} // namespace lutlib
