// The smallest bake that keeps a promise about its largest colour difference.
#pragma once

#include "lutlib/bake/bake.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lutlib {

/// Lattices of more nodes per axis keep their point samples: their cells are so small that rounding
/// rules the error, and a fit's memory grows with its nodes, beyond 10 GB at 256 a side.
inline constexpr int largest_fitted_size = 33;
/// That, as a clause for reports.
std::string fit_limit_text();

/// A bake whose nodes may have been fitted to the engine's lookup.
struct FilledBake {
    Bake bake;
    bool fitted = false;
    ErrorStats point_sampled; ///< when a fit was tried: by channel, of the point samples ...
    ErrorStats result;        ///< ... and of what was kept, over colours that the fit has not seen
    /// What rounding and clamping would have taken of the look's own samples, when others were
    /// fitted. A fit aims at the look held to 0..1, and chooses codes: bake.loss is then empty.
    BakeLoss look_loss = {};
};

/// bake(), with nodes fitted to the engine's lookup where that helps, up to largest_fitted_size.
FilledBake bake_fitted(const Transform& look, const Engine& engine, int size, int bits);

/// Bytes of the codes, three a node.
std::uint64_t lattice_bytes(int size, int bits);

struct Budget {
    double max_delta_e = 1;        ///< dE2000
    std::optional<int> size, bits; ///< only these, where given
    bool fit = true;               ///< fitted lattices may be used
};

struct BudgetBake {
    FilledBake filled;
    LookupError chosen_on;  ///< over the colours on which it was chosen
    LookupError checked_on; ///< over others, and uphill from the worst of them
    bool kept = false;      ///< both maxima are within the budget
    std::size_t tried = 0;  ///< combinations looked at
    double largest_delta_e() const;
};

/// The smallest combination that keeps the promise; of equal size, point samples come before a fit.
/// An engine's lookup costs the same for every one of them but for its memory, so the smallest is
/// also the fastest. The usual sizes are tried from below; every other size up to the first of them
/// that does is then searched by halves, since errors fall with size, but for the look's own sizes.
/// When none of the usual sizes does, the one that comes nearest, with `kept` false. Throws
/// UsageError when the engine takes no combination that was asked for.
BudgetBake bake_within(const Transform& look, const Engine& engine, const Budget& budget);

} // namespace lutlib
