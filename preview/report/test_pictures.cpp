#include "preview/report/test_pictures.h"

#include "lutlib/named.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace preview::report {

namespace {

using Light = std::array<double, 3>;

/// `light` is asked for the place of a texel in the panned picture.
ShownPicture made(Size size, const std::function<Light(int x, int y)>& light) {
    ShownPicture out;
    out.size = size;
    out.rgba.reserve(std::size_t{4} * size.width * size.height);
    for (int y = 0; y < static_cast<int>(size.height); ++y) {
        for (int x = 0; x < static_cast<int>(size.width); ++x) {
            for (const double channel : light(x, y)) {
                out.rgba.push_back(static_cast<float>(channel));
            }
            out.rgba.push_back(1);
        }
    }
    return out;
}

/// Odd places of a pyramid in most sizes, so that no level has it in its middle.
Size middle_texel(Size size) {
    return {size.width / 2 + (size.width > 2 ? 1 : 0), size.height / 2};
}

ShownPicture impulse(Size size, int pan) {
    const Size place = middle_texel(size);
    return made(size, [=](int x, int y) {
        const bool is_it =
            x + pan == static_cast<int>(place.width) && y == static_cast<int>(place.height);
        return is_it ? Light{3000, 2000, 1000} : Light{};
    });
}

/// The sun is half a degree wide, here of 45 degrees of height, and has about 1.6e9 cd/m2; half
/// floats hold 65504.
ShownPicture sun_disc(Size size, int pan) {
    const double radius = size.height * 0.25 / 45, top = 0.3 * size.height;
    const double left = 0.62 * size.width - pan;
    return made(size, [=](int x, int y) {
        const double apart = std::hypot(x + 0.5 - left, y + 0.5 - top);
        const double share = std::clamp(radius - apart + 0.5, 0.0, 1.0);
        const double sky = 0.35 + 0.4 * (1 - y / static_cast<double>(size.height));
        return Light{std::lerp(0.55 * sky, 40000.0, share), std::lerp(0.75 * sky, 38000.0, share),
                     std::lerp(sky, 35000.0, share)};
    });
}

/// Evenly in stops from left to right, and of each hue from top to bottom.
ShownPicture ramps(Size size, int pan) {
    constexpr double stops = 14, least = 0.004;
    return made(size, [=](int x, int y) {
        const double light =
            least *
            std::exp2(stops * std::clamp((x + pan) / static_cast<double>(size.width), 0.0, 1.0));
        const double hue = 2 * std::numbers::pi * y / static_cast<double>(size.height);
        const auto channel = [&](double turn) {
            return light * (0.6 + 0.4 * std::cos(hue - turn));
        };
        return Light{channel(0), channel(2.0944), channel(4.1888)};
    });
}

/// Of 0..1, the same for the same place.
double noise(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    std::uint32_t state = x * 73856093U ^ y * 19349663U ^ seed * 83492791U;
    state = (state ^ state >> 16U) * 0x7feb352dU;
    state = (state ^ state >> 15U) * 0x846ca68bU;
    return static_cast<double>(state ^ state >> 16U) / 4294967296.0;
}

/// Windows at night: small bright things of many brightnesses in the dark, sharp at their edges.
ShownPicture windows(Size size, int pan) {
    const int cell = std::max(static_cast<int>(size.height) / 18, 3);
    return made(size, [=](int x, int y) {
        const int column = (x + pan) / cell, row = y / cell;
        const bool is_pane = (x + pan) % cell < cell / 2 + 1 && y % cell < (2 * cell + 2) / 3;
        const auto of = [&](std::uint32_t seed) {
            return noise(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), seed);
        };
        const double glow = 0.004 + 0.02 * y / static_cast<double>(size.height);
        if (!is_pane || of(1) < 0.6) {
            return Light{glow, glow, 1.6 * glow};
        }
        const double light = std::exp2(-3 + 11 * of(2)), warmth = of(3);
        return Light{light, light * (0.95 - 0.25 * warmth), light * (0.85 - 0.6 * warmth)};
    });
}

constexpr TestPicture rows[] = {
    {"impulse", "one texel of light in the dark", impulse,
     [](Size size) { return std::optional(middle_texel(size)); }},
    {"sun disc", "the sun, half a degree wide, in a sky", sun_disc},
    {"ramps", "14 stops of every hue", ramps},
    {"windows", "bright windows at night, an HDR picture of hard edges", windows},
};

} // namespace

std::span<const TestPicture> test_pictures() {
    return rows;
}

const TestPicture* test_picture_named(std::string_view name) {
    return lutlib::find_named(rows, name);
}

} // namespace preview::report
