#include "lutlib/io/read_back.h"

#include "lutlib/codes.h"
#include "lutlib/error.h"
#include "lutlib/io/look.h"
#include "lutlib/metrics/climb.h"
#include "lutlib/metrics/error_samples.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace lutlib::io {
namespace {

// Float arithmetic of two programs, as a share of the values, whose least is 1.
constexpr double rounding_noise = 2e-6;

constexpr SampleLimits limits{
    .even = 4'000, .grid = std::size_t{1} << 16, .between = std::size_t{1} << 14};

// A rounding to the format's numbers, which is reported where it happens.
double rounding_of(const Holds& holds) {
    return holds.integer_bits > 0 ? 0.51 / CodeDepth{holds.integer_bits}.maximum()
           : holds.decimals > 0   ? 0.51 * std::pow(10.0, -holds.decimals)
                                  : 0;
}

// Inputs that crowd towards the dark end, where tables are steep, and the middles between the
// entries of a long one, which are no breaks.
void append_of_table(std::vector<Rgb>& out, const Lut& lut) {
    constexpr int dark = 400;
    const Domain& domain = lut.domain();
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
}

} // namespace

std::optional<Loss> lost_in_reading(const FileFormat& format, const std::string& bytes,
                                    const Lut& written) {
    const Look read =
        Look::of_bytes(bytes, "the file." + format.extensions.first(),
                       {.format = std::string(format.name),
                        .interpolation = written.cube ? written.interpolation : std::nullopt});
    // Errors beyond what reading may round.
    const ErrorsOf errors_of = [&, before = Transform::of(written), after = read.exact()](
                                   std::span<const Rgb> in, std::span<double> errors) {
        const std::vector<RgbD> right = images_of(before, in), got = images_of(after, in);
        for (std::size_t i = 0; i < in.size(); ++i) {
            const double error = largest_magnitude(got[i] - right[i]);
            const double noise = rounding_noise * std::max(1.0, largest_magnitude(right[i])) +
                                 rounding_of(format.holds);
            errors[i] = error > noise ? error : 0;
        }
    };
    const ErrorSamples samples =
        error_samples(written.domain(), united(breaks_of(written), read.breaks()), limits);
    std::vector<Rgb> inputs = samples.even;
    inputs.insert(inputs.end(), samples.hiding.begin(), samples.hiding.end());
    append_of_table(inputs, written);
    std::vector<double> errors(inputs.size());
    errors_of(inputs, errors);
    const double most = climbed(inputs, errors, samples.axis, errors_of).error;
    if (most == 0) {
        return std::nullopt;
    }
    return Loss{"what OpenColorIO makes of the file differs from the look, largest error", most,
                ""};
}

} // namespace lutlib::io
