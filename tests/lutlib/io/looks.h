// Looks for the tests of files: smooth as real ones are, of every shape that a Lut can have.
#pragma once

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/lut.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace lutlib {

/// A smooth strong look of three channels that mix; 0..1 in gives about 0..1 out.
inline Rgb grade(Rgb c) {
    const float luma = 0.2F * c.r + 0.7F * c.g + 0.1F * c.b;
    const auto channel = [&](float v, float warmth) {
        const float saturated = luma + 1.4F * (v - luma);
        return 0.02F + 0.9F * (saturated - 0.1F * std::sin(6.0F * saturated)) + warmth * luma;
    };
    return {channel(c.r, 0.05F), channel(c.g, 0.0F), channel(c.b, -0.06F)};
}

inline Lut3D graded_cube(int size, const Domain& domain) {
    Lut3D cube = identity_cube(size, domain);
    for (Rgb& node : cube.nodes) {
        Rgb t;
        for (std::size_t c = 0; c < 3; ++c) {
            t[c] = (node[c] - domain.min[c]) / (domain.max[c] - domain.min[c]);
        }
        node = grade(t);
    }
    return cube;
}

/// A logarithmic curve onto 0..1.
inline Lut1D log_curve(int size, const Domain& domain) {
    Lut1D curve{domain, {}};
    for (int i = 0; i < size; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(size - 1);
        const auto v = [&](float k) { return std::log2(1 + k * t) / std::log2(1 + k); };
        curve.entries.push_back({v(7), v(6), v(5)});
    }
    return curve;
}

struct NamedLut {
    std::string name;
    Lut lut;
};

inline std::vector<NamedLut> looks_of_every_shape(int size = 17) {
    const Domain hdr{{0, 0, 0}, {4, 4, 4}};
    const Domain negative{{-1, -1, -1}, {1, 1, 1}};
    const Domain uneven{{-0.5F, 0, 0.25F}, {1, 2, 0.5F}};
    const auto look = [](std::optional<Lut1D> shaper, std::optional<Lut3D> cube) {
        Lut lut;
        lut.shaper = std::move(shaper);
        lut.cube = std::move(cube);
        return lut;
    };
    Lut trilinear = look({}, graded_cube(size, {}));
    trilinear.interpolation = Interpolation::trilinear;
    return {
        {"cube", look({}, graded_cube(size, {}))},
        {"cube_hdr", look({}, graded_cube(size, hdr))},
        {"cube_negative", look({}, graded_cube(size, negative))},
        {"cube_uneven", look({}, graded_cube(size, uneven))},
        {"curve", look(log_curve(256, {}), {})},
        {"curve_hdr", look(log_curve(256, hdr), {})},
        {"curve_uneven", look(log_curve(64, uneven), {})},
        {"shaper_and_cube", look(log_curve(1024, hdr), graded_cube(size, {}))},
        {"cube_trilinear", trilinear},
        {"shaper_and_cube_hdr", look(log_curve(64, {}), graded_cube(size, {{0, 0, 0}, {2, 2, 2}}))},
    };
}

/// The corners of a domain and random colours within it, and beyond it by a share of its width.
inline std::vector<Rgb> colors_in(const Domain& domain, int count = 5000, float margin = 0) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> position(-margin, 1 + margin);
    std::vector<Rgb> out{domain.min, domain.max};
    for (int i = 0; i < count; ++i) {
        Rgb c;
        for (std::size_t k = 0; k < 3; ++k) {
            c[k] = domain.min[k] + position(random) * (domain.max[k] - domain.min[k]);
        }
        out.push_back(c);
    }
    return out;
}

/// Of any channel, between colours of the same place.
inline double largest_difference(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        worst = std::max(worst, largest_magnitude(to_double(a[i]) - to_double(b[i])));
    }
    return worst;
}

inline std::vector<Rgb> evaluated(const Lut& lut, const std::vector<Rgb>& in) {
    std::vector<Rgb> out;
    for (const Rgb& c : in) {
        out.push_back(evaluate(lut, c));
    }
    return out;
}

} // namespace lutlib
