// What lattices of usual sizes miss of a look, measured.
#include "lutlib/health/parts.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/resample/sample_lut.h"

#include <algorithm>

namespace lutlib::health {
std::array<LatticeError, 2> measure_lattices(const Lut& lut, const Transform& exact,
                                             const Codes& codes) {
    std::array<LatticeError, 2> out;
    out[0].nodes = 16;
    out[1].nodes = 33;
    const auto all_finite = [](const std::vector<Rgb>& values) {
        return std::all_of(values.begin(), values.end(), finite);
    };
    if ((lut.cube && !all_finite(lut.cube->nodes)) ||
        (lut.shaper && !all_finite(lut.shaper->entries))) {
        return out;
    }
    // Enough for a maximum within 10 % of the full search's, in a tenth of its time.
    constexpr SampleLimits limits{
        .even = 20'000, .grid = std::size_t{1} << 17, .between = std::size_t{1} << 15};
    const Metric eye = codes.results == Results::hdr ? Metric::delta_e_itp : Metric::delta_e_2000;
    for (LatticeError& error : out) {
        Lut lattice;
        lattice.cube = sample_cube(exact, lut.domain(), error.nodes);
        const Difference difference =
            measure(exact, Transform::of(lattice),
                    error_samples(lut.domain(), united(breaks_of(lut), breaks_of(lattice)), limits),
                    codes.output);
        error.measured = true;
        error.code = difference.absolute;
        error.to_eye = difference.by(eye);
        error.in = difference.worst.in;
    }
    return out;
}

} // namespace lutlib::health
