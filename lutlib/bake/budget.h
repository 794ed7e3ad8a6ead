// The smallest bake that keeps a promise about its largest colour difference.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/fit/acceptance.h"

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
    /// When a fit was tried: measure_lookup() of the point samples and of what was kept. Its even
    /// colours and its climbs are others than those that the fit was made of.
    std::optional<Difference> point_sampled = {}, result = {};
    /// The largest difference between the channels' errors of a grey, in code values, of both.
    double tint_of_point_samples = 0, tint = 0;
    /// What rounding and clamping would have taken of the look's own samples, when others were
    /// fitted. A fit aims at the look held to 0..1, and chooses codes: bake.loss is then empty.
    BakeLoss look_loss = {};
};

/// bake(), with nodes fitted to the engine's lookup where that helps, up to largest_fitted_size:
/// where neither the largest nor the mean error grows, in code values or to the eye.
FilledBake bake_fitted(const Transform& look, const Engine& engine, int size, int bits,
                       const FitView& view = {});

/// Bytes of the codes, three a node.
std::uint64_t lattice_bytes(int size, int bits);

/// A promise about the largest error of an engine's lookup, and what may be used to keep it.
struct Budget {
    double most = 1;               ///< by the metric
    std::optional<int> size, bits; ///< only these, where given
    bool fit = true;               ///< fitted lattices may be used
    Metric metric = Metric::delta_e_2000;
    Viewing viewing = {};
    Breaks breaks = no_breaks();   ///< of the look
    std::optional<int> nodes = {}; ///< of the look's own lattice over 0..1, where it is one
};

struct BudgetBake {
    FilledBake filled;
    Difference error;      ///< measure_lookup()
    double largest = 0;    ///< by the metric of the promise
    bool kept = false;     ///< it is within the budget
    std::size_t tried = 0; ///< combinations looked at
};

/// Point samples whose largest error exceeds the promise by more than this factor are not tried as
/// a fit, and no more than so many are: a fit aims at the mean, lowers the largest error of real
/// looks by a factor of 1 to 1.6, and takes longer than the point samples of many sizes.
inline constexpr double fit_reach = 1.45;
inline constexpr int most_fits = 3;

/// Every size from 2 to 128, and k(n-1)+1 up to 256 for a look of n nodes, whose nodes it holds; of
/// the sizes that the engine takes, and whose picture is no larger than a texture may be. Rising.
std::vector<int> sizes_tried(const Engine& engine, std::optional<int> nodes);

/// The smallest combination that keeps the promise; of equal size, point samples come before a fit.
/// An engine's lookup costs the same for every one of them but for its memory, so the smallest is
/// also the fastest; but one that the engine takes only where the project says so
/// (Engine::usual_sizes) comes behind all others. Of sizes_tried() each is left at the first colour that breaks the promise. When
/// none keeps it, the one that comes nearest of the few that seemed the nearest, with `kept` false.
/// Throws UsageError when the engine takes no combination that was asked for.
BudgetBake bake_within(const Transform& look, const Engine& engine, const Budget& budget);

} // namespace lutlib
