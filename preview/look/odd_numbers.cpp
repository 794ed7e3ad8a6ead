#include "preview/look/odd_numbers.h"

#include <fmt/format.h>

#include <cmath>

namespace preview {

namespace {

constexpr float largest_half = 65504; // as shaders/common/sanitise.glsl has it

} // namespace

OddPixels settle_odd_numbers(std::span<float> rgba) {
    OddPixels out;
    for (std::size_t at = 0; at + 3 < rgba.size(); at += 4) {
        bool has_nan = false, has_infinity = false, has_negative = false;
        for (std::size_t c = 0; c < 4; ++c) {
            float& number = rgba[at + c];
            const bool is_color = c < 3;
            has_negative = has_negative || (is_color && number < 0);
            if (std::isfinite(number)) {
                continue;
            }
            has_nan = has_nan || (is_color && std::isnan(number));
            has_infinity = has_infinity || (is_color && number > 0);
            number = number > 0 ? largest_half : 0;
        }
        out.with_nan += has_nan ? 1 : 0;
        out.with_infinity += has_infinity ? 1 : 0;
        out.with_negative += has_negative ? 1 : 0;
    }
    return out;
}

std::vector<std::string> told_of(const OddPixels& odd) {
    std::vector<std::string> out;
    const auto tell = [&](std::size_t count, const char* what) {
        if (count > 0) {
            out.push_back(
                fmt::format("{} {} {}", count, count == 1 ? "pixel holds" : "pixels hold", what));
        }
    };
    tell(odd.with_nan, "NaN, which is taken for 0");
    tell(odd.with_infinity, "infinity, which is taken for 65504, the largest half float");
    tell(odd.with_negative, "numbers below 0; what is still below 0 as it is shown is 0 there");
    return out;
}

} // namespace preview
