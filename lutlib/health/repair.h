// What of a broken look can be repaired, with the smallest change that does it. A repair gives no
// values beyond those that the look gave, and one that would make the look fold, fall,
// clip or stand still where it did not is left out.
#pragma once

#include "lutlib/lut.h"
#include "lutlib/metrics/stats.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

struct RepairOptions {
    bool clamp = false; ///< outputs to 0..1
};

/// One repair that changed something, over all rounds.
struct RepairStep {
    std::string_view name{};
    std::string words{};
    std::size_t changed = 0; ///< values; one that is changed in two rounds counts twice
    /// Largest change of a value that was finite before.
    double largest = 0;
    /// The same to the eye, of the changed colours (of the round that changed most): dE2000, of HDR
    /// dE-ITP.
    ErrorStats to_eye{};
};

struct Repaired {
    Lut lut;
    std::vector<RepairStep> steps; ///< empty: nothing had to be changed
    std::vector<std::string> left; ///< what is not repaired, and why
};

/// One row of the table of repairs, in the order in which they are made.
struct RepairInfo {
    std::string_view name, help;
    /// Changes the look in place and says how; an empty text where there is nothing to do.
    std::string (*apply)(Lut& lut, const RepairOptions& options);
};
std::span<const RepairInfo> repairs();

/// Every repair in turn, in rounds until one has nothing to do, so that a second run over the
/// result changes nothing. Throws Error when a table has not one finite value to start from.
Repaired repair(const Lut& lut, const RepairOptions& options = {});

} // namespace lutlib
