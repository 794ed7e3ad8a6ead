// Passes against their twins in double, on the very images that they read in a frame.
#pragma once

#include "preview/check/observe.h"
#include "preview/check/situation.h"

#include <cmath>
#include <string>
#include <vector>

namespace preview {

/// How far a pass is from its twin.
struct TwinFigure {
    std::string pass;
    /// (|pass - twin| - doubt) / (|twin| + floor), at most and as allowed; the floor is 1, of light
    /// before the resolve and of it the smallest normal half float. Lighting alone has doubts: the
    /// share of a shadow that hangs on roundings, and 8-bit weights of texture units.
    double largest = 0, bound = 0;
    /// Texels beyond the bound, and how many may be: comparisons that hang on a rounding may fall
    /// either way.
    std::uint64_t beyond = 0, may_be_beyond = 0;
    /// Of the channel that is worst: how much more light the pass has than its twin, rounded as the
    /// pass's format should, as a share of that and of the floor; and as allowed.
    double drift = 0, drift_bound = 0;
    bool is_near() const { return beyond <= may_be_beyond; }
    bool keeps_light() const { return std::abs(drift) <= drift_bound; }
};

/// The same frame, and what the lighting pass leaves is copied before see-through surfaces are drawn
/// over it; as it is where none are.
Graph with_lighting_apart(const Graph& graph);

/// The passes of this frame that have a twin which can be asked.
std::vector<TwinFigure> twin_figures(const Situation& situation, const Graph& graph,
                                     const std::vector<Observed>& observed);

} // namespace preview
