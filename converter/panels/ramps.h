// A look along its neutral axis, and along one channel at a time.
#pragma once

#include "converter/panels/panel.h"

namespace converter {

/// The results of one channel along a ramp of inputs.
struct Ramp {
    std::size_t channel = 0;
    std::vector<double> in, out;
};

/// Three equal channels, from the lowest to the highest of the domain.
std::vector<lutlib::RgbD> neutral_codes(const lutlib::Domain& domain, int count);

/// Of inputs with three equal channels, from the lowest to the highest of the domain: each
/// channel's results.
std::vector<Ramp> neutral_ramps(const ShownLook& look);
/// Of each channel over its domain, the others at the domain's low end: its own results.
std::vector<Ramp> channel_ramps(const ShownLook& look);

} // namespace converter
