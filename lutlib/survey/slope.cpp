#include "lutlib/survey/slope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lutlib {
namespace {

// Of 95 %, two sided, by degrees of freedom.
constexpr std::array<double, 11> student{0,     12.706, 4.303, 3.182, 2.776, 2.571,
                                         2.447, 2.365,  2.306, 2.262, 2.228};

} // namespace

Slope slope_of(const std::vector<std::pair<double, double>>& points, double floor) {
    std::vector<std::pair<double, double>> logs;
    for (const auto& [x, y] : points) {
        if (x > 0 && y > floor && std::isfinite(y)) {
            logs.emplace_back(std::log(x), std::log(y));
        }
    }
    Slope out;
    out.points = logs.size();
    out.interval = std::numeric_limits<double>::infinity();
    if (logs.size() < 2) {
        return out;
    }
    const auto n = static_cast<double>(logs.size());
    double mx = 0, my = 0;
    for (const auto& [x, y] : logs) {
        mx += x / n;
        my += y / n;
    }
    double xx = 0, xy = 0;
    for (const auto& [x, y] : logs) {
        xx += (x - mx) * (x - mx);
        xy += (x - mx) * (y - my);
    }
    if (!(xx > 0)) {
        return out;
    }
    out.value = xy / xx;
    double rest = 0;
    for (const auto& [x, y] : logs) {
        const double r = y - my - out.value * (x - mx);
        rest += r * r;
    }
    if (logs.size() > 2) {
        const std::size_t freedom = logs.size() - 2;
        out.interval = student[std::min(freedom, student.size() - 1)] *
                       std::sqrt(rest / static_cast<double>(freedom) / xx);
    }
    return out;
}

} // namespace lutlib
