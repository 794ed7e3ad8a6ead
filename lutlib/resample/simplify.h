// Leaving out what a look does not need, each omission proved equal within a stated bound.
//
// The bounds hold for every input of the look's domain, read trilinearly or tetrahedrally, before
// the lookup's own rounding: both sides are straight between the finer one's nodes, so the largest
// difference lies at a node, and all nodes are looked at.
#pragma once

#include "lutlib/lut.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

struct SimplifyOptions {
    /// The largest difference of an output channel that an omission may make, in all.
    double tolerance = 1e-6;
};

/// One thing that was left out.
struct Omission {
    std::string_view name;
    std::string words;
    double bound = 0; ///< largest difference of an output channel that it makes
};

struct Simplified {
    Lut lut; ///< with neither shaper nor cube: the look is the identity and need not be applied
    std::vector<Omission> omissions;
    double bound = 0; ///< of all omissions together
};

/// One row of the table of rules, in the order in which they are tried.
struct SimplifyRule {
    std::string_view name, help;
    /// Leaves something out of `lut` when the difference is at most `tolerance`; returns what, with
    /// empty words where it does not apply.
    Omission (*apply)(Lut& lut, double tolerance);
};
std::span<const SimplifyRule> simplify_rules();

/// Every rule, again until none applies. The look must be valid.
Simplified simplify(const Lut& lut, const SimplifyOptions& options = {});

/// Nodes of the cube that no input reaches, however it is interpolated.
struct Unreachable {
    std::size_t nodes = 0;     ///< by any input of the look
    std::size_t of_engine = 0; ///< by inputs of 0..1 in every channel, those above included
    std::size_t all = 0;
};
Unreachable unreachable_nodes(const Lut& lut);

} // namespace lutlib
