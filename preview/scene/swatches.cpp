#include "preview/scene/swatches.h"

#include "lutlib/color/primaries.h"

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

double linear_of_double(double code) {
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

/// CIE 15:2004, 8.2.1.1, backwards.
double ratio_of(double f) {
    constexpr double knee = 6.0 / 29;
    return f > knee ? f * f * f : 3 * knee * knee * (f - 4.0 / 29);
}

} // namespace

glm::vec3 linear_of(const Swatch& swatch) {
    glm::vec3 linear;
    for (int channel = 0; channel < 3; ++channel) {
        linear[channel] = static_cast<float>(
            linear_of_double(swatch.srgb[static_cast<std::size_t>(channel)] / 255.0));
    }
    return linear;
}

glm::vec3 linear_of(std::uint32_t srgb) {
    const auto code = [&](int shift) { return static_cast<std::uint8_t>(srgb >> shift & 255u); };
    return linear_of(Swatch{"", {code(16), code(8), code(0)}});
}

glm::vec3 linear_of_lab(glm::vec3 lab) {
    const double y = (static_cast<double>(lab.x) + 16) / 116;
    const lutlib::RgbD white = lutlib::xyz_of(lutlib::white_d65);
    const lutlib::RgbD xyz{white.r * ratio_of(y + static_cast<double>(lab.y) / 500),
                           white.g * ratio_of(y),
                           white.b * ratio_of(y - static_cast<double>(lab.z) / 200)};
    const lutlib::RgbD linear = lutlib::inverse(lutlib::rgb_to_xyz(lutlib::rec709)) * xyz;
    const auto of = [](double v) { return static_cast<float>(std::max(v, 0.0)); };
    return {of(linear.r), of(linear.g), of(linear.b)};
}

glm::vec3 linear_of(const LabSwatch& swatch) {
    return linear_of_lab({swatch.lab[0], swatch.lab[1], swatch.lab[2]});
}

float linear_of_code(float code) {
    return static_cast<float>(linear_of_double(static_cast<double>(code)));
}

} // namespace preview
