#include "lutlib/plot/palette.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace plot {
namespace {

struct Stop {
    double r, g, b;
};
constexpr std::array<Stop, 5> stops{{
    {0, 34, 78},
    {65, 77, 107},
    {125, 124, 120},
    {190, 176, 108},
    {254, 232, 56},
}};

} // namespace

Rgb8 series_color(std::size_t series, bool pale) {
    const std::string_view text = series_colors[series % series_colors.size()];
    Rgb8 out{};
    for (std::size_t c = 0; c < out.size(); ++c) {
        int code = 0;
        std::from_chars(text.data() + 1 + 2 * c, text.data() + 3 + 2 * c, code, 16);
        out[c] = static_cast<std::uint8_t>(pale ? (code + 255) / 2 : code);
    }
    return out;
}

std::string css_color(Rgb8 color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

std::string heat_color(std::size_t level) {
    const double place = static_cast<double>(std::min(level, heat_levels - 1)) *
                         (stops.size() - 1) / (heat_levels - 1);
    const auto first = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    const double t = place - static_cast<double>(first);
    const auto mixed = [t](double a, double b) {
        return static_cast<int>(std::lround(std::lerp(a, b, t)));
    };
    const Stop &a = stops[first], &b = stops[first + 1];
    return fmt::format("#{:02x}{:02x}{:02x}", mixed(a.r, b.r), mixed(a.g, b.g), mixed(a.b, b.b));
}

} // namespace plot
