#include "lutlib/interpolation/lattice_reader.h"

#include <algorithm>
#include <memory>

namespace lutlib {

double LatticeReader::input_at(std::size_t channel, double wanted) const {
    // Bisection needs nothing but that places do not fall.
    constexpr int halvings = 50;
    double low = domain.min[channel], high = domain.max[channel];
    for (int i = 0; i < halvings; ++i) {
        const double middle = low + (high - low) / 2;
        (place(middle, channel) < wanted ? low : high) = middle;
    }
    return low + (high - low) / 2;
}

LatticeReader reader_of(const Lut& lut, Interpolation how) {
    LatticeReader out{lut.cube->size, how, lut.domain(), {}};
    const auto shaper = lut.shaper ? std::make_shared<const Lut1D>(*lut.shaper) : nullptr;
    out.place = [shaper, domain = lut.cube->domain, size = out.size](double in, std::size_t c) {
        const double x = shaper ? evaluate_exact(*shaper, {in, in, in})[c] : in;
        const double min = domain.min[c], max = domain.max[c];
        return std::clamp((x - min) / (max - min), 0.0, 1.0) * (size - 1);
    };
    return out;
}

} // namespace lutlib
