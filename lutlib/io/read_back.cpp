#include "lutlib/io/read_back.h"

#include "lutlib/codes.h"
#include "lutlib/error.h"
#include "lutlib/io/look.h"
#include "lutlib/metrics/compare.h"

#include <algorithm>
#include <cmath>

namespace lutlib::io {
namespace {

// Float arithmetic of two programs, as a share of the values, whose least is 1.
constexpr double rounding_noise = 2e-6;

// A rounding to the format's numbers, which is reported where it happens.
double rounding_of(const Holds& holds) {
    return holds.integer_bits > 0 ? 0.51 / CodeDepth{holds.integer_bits}.maximum()
           : holds.decimals > 0   ? 0.51 * std::pow(10.0, -holds.decimals)
                                  : 0;
}

// Spread evenly, the middles between the entries of a 1D table, and inputs that crowd towards the
// dark end, where tables are steep.
std::vector<Rgb> inputs_for(const Lut& lut) {
    constexpr int lattice = 9, random = 4000, dark = 400;
    const Domain& domain = lut.domain();
    std::vector<Rgb> out = samples_over(domain, lattice, random);
    const auto add = [&](double share) {
        Rgb at;
        for (std::size_t c = 0; c < 3; ++c) {
            at[c] = static_cast<float>(std::lerp(static_cast<double>(domain.min[c]),
                                                 static_cast<double>(domain.max[c]), share));
        }
        out.push_back(at);
    };
    for (int i = 0; i < dark; ++i) {
        add(std::pow(2.0, -16.0 * i / dark));
    }
    for (int i = 0; lut.shaper && i + 1 < lut.shaper->size(); ++i) {
        add((i + 0.5) / (lut.shaper->size() - 1));
    }
    return out;
}

} // namespace

std::optional<Loss> lost_in_reading(const FileFormat& format, const std::string& bytes,
                                    const Lut& written) {
    const Look read =
        Look::of_bytes(bytes, "the file." + format.extensions.first(),
                       {.format = std::string(format.name),
                        .interpolation = written.cube ? written.interpolation : std::nullopt});
    const std::vector<Rgb> inputs = inputs_for(written);
    const std::vector<RgbD> before = images_of(Transform::of(written), inputs),
                            after = images_of(read.exact(), inputs);
    double most = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const double error = largest_magnitude(after[i] - before[i]);
        const double noise = rounding_noise * std::max(1.0, largest_magnitude(before[i])) +
                             rounding_of(format.holds);
        most = error > noise ? std::max(most, error) : most;
    }
    if (most == 0) {
        return std::nullopt;
    }
    return Loss{"what OpenColorIO makes of the file differs from the look, largest error", most,
                ""};
}

} // namespace lutlib::io
