#include "lutlib/plot/palette.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

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
