// What leaving out saves: frames from a bare HDR picture to a full scene, with everything forced
// and as the program draws them, and how far apart the two are.
#pragma once

#include "preview/report/renderer.h"

#include <functional>
#include <string>
#include <vector>

namespace preview::report {

/// A step on the way to the full scene.
struct SavingStage {
    std::string name;
    Situation situation; ///< not forced
    /// The largest difference of a channel of the finished picture that leaving out may make, in
    /// codes of 0..1. 0: not a bit.
    double bound = 0;
};

struct SavingRow {
    std::string name;
    Costs forced, usual;
    double largest = 0, bound = 0; ///< difference of a channel of the finished picture
    bool holds() const { return largest <= bound; }
};

/// At the size of `situation`, which is studied(); its scene, or the sample where it shows a
/// picture. `look` is laid over all stages from the one that names it on; null: none.
std::vector<SavingStage> saving_stages(const Situation& situation, const GpuLook* look);

/// Of any channel; infinite where one of them is no number.
double largest_difference(const reference::Image& a, const reference::Image& b);

SavingRow saving_of(Renderer& renderer, const SavingStage& stage, int rounds);

} // namespace preview::report
