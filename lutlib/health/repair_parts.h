// What the table of repairs is made of. Each changes the look in place and says how; an empty text
// where there is nothing to do.
#pragma once

#include "lutlib/health/repair.h"

#include <vector>

namespace lutlib::health {

std::string fill_non_finite(Lut& lut, const RepairOptions& options);
std::string straighten_table(Lut& lut, const RepairOptions& options);
std::string level_spikes(Lut& lut, const RepairOptions& options);
std::string straighten_neutrals(Lut& lut, const RepairOptions& options);
std::string clamp_outputs(Lut& lut, const RepairOptions& options);

/// The finite outputs of a look: lowest and highest of all channels.
struct OutputRange {
    double low = 0, high = 0;
};
OutputRange finite_range(const std::vector<Rgb>& outputs);

} // namespace lutlib::health
