#include "preview/finish/wipe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace preview {

namespace {

/// Quarters of a turn are exact.
std::array<double, 2> normal_of(float angle) {
    const double turns = std::remainder(static_cast<double>(angle) / 360, 1.0);
    const double quarters = 4 * turns;
    if (quarters == std::round(quarters)) {
        const auto quarter = (static_cast<int>(std::lround(quarters)) + 4) % 4;
        constexpr std::array<std::array<double, 2>, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        return exact[static_cast<std::size_t>(quarter)];
    }
    const double radians = 2 * std::numbers::pi * turns;
    return {std::cos(radians), std::sin(radians)};
}

/// The line's way over a picture: where it begins, and how long it is.
struct Way {
    double begin = 0, length = 0;
};
Way way_over(const std::array<double, 2>& normal, Size size) {
    const double across = normal[0] * size.width, down = normal[1] * size.height;
    return {std::min(across, 0.0) + std::min(down, 0.0), std::abs(across) + std::abs(down)};
}

} // namespace

WipeShape wipe_shape(const Wipe& wipe, const Compare& compare, Size size) {
    const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    if (&compare == &compare_box) {
        return {wipe.box_x * width, wipe.box_y * height, (wipe.box_x + wipe.box_width) * width,
                (wipe.box_y + wipe.box_height) * height};
    }
    const std::array<double, 2> normal = normal_of(wipe.split_angle);
    const Way way = way_over(normal, size);
    return {static_cast<float>(normal[0]), static_cast<float>(normal[1]),
            static_cast<float>(way.begin + static_cast<double>(wipe.split) * way.length), 0};
}

WipeShape placed(const WipeShape& shape, const Compare& compare, float left, float top,
                 float scale) {
    if (&compare == &compare_box) {
        return {left + scale * shape[0], top + scale * shape[1], left + scale * shape[2],
                top + scale * shape[3]};
    }
    return {shape[0], shape[1], shape[0] * left + shape[1] * top + scale * shape[2], 0};
}

bool shows_a(const WipeShape& shape, const Compare& compare, double x, double y) {
    const auto at = [&](std::size_t i) { return static_cast<double>(shape[i]); };
    return &compare == &compare_box ? x >= at(0) && y >= at(1) && x < at(2) && y < at(3)
                                    : x * at(0) + y * at(1) < at(2);
}

float split_at(float split_angle, float x, float y, Size size) {
    const std::array<double, 2> normal = normal_of(split_angle);
    const Way way = way_over(normal, size);
    const double along =
        normal[0] * static_cast<double>(x) + normal[1] * static_cast<double>(y) - way.begin;
    return static_cast<float>(std::clamp(along / way.length, 0.0, 1.0));
}

} // namespace preview
