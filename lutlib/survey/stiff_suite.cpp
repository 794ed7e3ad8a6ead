#include "lutlib/survey/stiff_suite.h"

#include "lutlib/color/luma.h"
#include "lutlib/named.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace lutlib {
namespace {

// Every function below takes a colour of 0..1, whatever the lattice's domain is.
template <class F>
Lut3D cube_of(int size, F f, const Domain& domain = {}) {
    Lut3D cube{domain, size, {}};
    const auto n = static_cast<std::size_t>(size);
    cube.nodes.reserve(n * n * n);
    const double step = 1.0 / (size - 1);
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r) {
                cube.nodes.push_back(to_float(f(RgbD{r * step, g * step, b * step})));
            }
        }
    }
    return cube;
}

template <class F>
Lut look_of(int size, F f, const Domain& domain = {}) {
    Lut lut;
    lut.cube = cube_of(size, f, domain);
    return lut;
}

// The same function of each channel.
template <class F>
auto each_channel(F f) {
    return [f](RgbD c) { return RgbD{f(c.r), f(c.g), f(c.b)}; };
}

template <class F>
Lut1D curve_of(int size, F f) {
    Lut1D curve{{}, {}};
    for (int i = 0; i < size; ++i) {
        const auto v = static_cast<float>(f(static_cast<double>(i) / (size - 1)));
        curve.entries.push_back({v, v, v});
    }
    return curve;
}

RgbD grey(double v) {
    return {v, v, v};
}

double step_at_half(double x) {
    return x < 0.5 ? 0 : 1;
}

// The steepest part of a film's shoulder, turned up: a logistic curve of the given slope at 0.5.
double shoulder(double x, double slope) {
    return 1 / (1 + std::exp(-4 * slope * (x - 0.5)));
}

double smooth(double x) {
    return x * x * (3 - 2 * x);
}

Lut with_spike(float height) {
    Lut lut;
    lut.cube = identity_cube(33);
    lut.cube->at(16, 16, 16) = {height, height, height};
    return lut;
}

// Integers hashed to 0..1 (Wellons, "Prospecting for Hash Functions", 2018), so that noise is the
// same on every machine.
double noise(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352dU;
    x = (x ^ (x >> 15)) * 0x846ca68bU;
    return static_cast<double>(x ^ (x >> 16)) / 4294967295.0;
}

Lut noise_look() {
    Lut lut;
    lut.cube = identity_cube(17);
    std::uint32_t seed = 0;
    for (Rgb& node : lut.cube->nodes) {
        node = to_float({noise(seed), noise(seed + 1), noise(seed + 2)});
        seed += 3;
    }
    return lut;
}

constexpr std::array<StiffLook, 33> stiff_look_rows{{
    {"identity", "the identity, for comparison", 1,
     [] { return look_of(33, [](RgbD c) { return c; }); }},
    {"constant_black", "every node 0", 0, [] { return look_of(17, [](RgbD) { return grey(0); }); }},
    {"constant_grey", "every node 0.5", 0,
     [] { return look_of(17, [](RgbD) { return grey(0.5); }); }},
    {"step", "each channel 0 below 0.5, else 1", 32,
     [] { return look_of(33, each_channel(step_at_half)); }},
    {"step_luma", "black where luma is below 0.5, else white", 32,
     [] { return look_of(33, [](RgbD c) { return grey(step_at_half(luma(c))); }); }},
    {"step_fine", "each channel's step as a 1D table of 65536", 65535,
     [] {
         Lut lut;
         lut.shaper = curve_of(65536, step_at_half);
         return lut;
     }},
    {"posterised", "each channel in five levels", 8,
     [] {
         return look_of(33, each_channel([](double x) { return std::floor(x * 4 + 0.5) / 4; }));
     }},
    {"shoulder_2", "logistic shoulder of slope 2 a channel", 1.99935,
     [] { return look_of(65, each_channel([](double x) { return shoulder(x, 2); })); }},
    {"shoulder_4", "logistic shoulder of slope 4 a channel", 3.99479,
     [] { return look_of(65, each_channel([](double x) { return shoulder(x, 4); })); }},
    {"shoulder_8", "logistic shoulder of slope 8 a channel", 7.83740,
     [] { return look_of(65, each_channel([](double x) { return shoulder(x, 8); })); }},
    {"shoulder_16", "logistic shoulder of slope 16 a channel", 14.7878,
     [] { return look_of(65, each_channel([](double x) { return shoulder(x, 16); })); }},
    {"shoulder_64", "logistic shoulder of slope 64 a channel", 30.8489,
     [] { return look_of(65, each_channel([](double x) { return shoulder(x, 64); })); }},
    {"shoulder_luma_8", "every channel scaled by a shoulder of slope 8 of luma", 5.71,
     [] { return look_of(65, [](RgbD c) { return shoulder(luma(c), 8) * c; }); }},
    {"shoulder_1000", "logistic shoulder of slope 1000 as a 1D table", 980.585,
     [] {
         Lut lut;
         lut.shaper = curve_of(4096, [](double x) { return shoulder(x, 1000); });
         return lut;
     }},
    {"gain_1000", "each channel times 1000, unclipped", 1000,
     [] { return look_of(33, [](RgbD c) { return 1000 * c; }); }},
    {"gain_1000_clipped", "each channel times 1000 about 0.5, clipped to 0..1", 1000,
     [] {
         Lut lut;
         lut.shaper = curve_of(65536, [](double x) { return saturate(1000 * (x - 0.5) + 0.5); });
         return lut;
     }},
    {"negative", "minus the input: every output but black's below 0", 1,
     [] { return look_of(17, [](RgbD c) { return -1 * c; }); }},
    {"huge", "corners of plus and minus 1e30 in turn", 4e30,
     [] {
         Lut lut;
         lut.cube = identity_cube(3);
         for (std::size_t i = 0; i < lut.cube->nodes.size(); ++i) {
             const float v = i % 2 ? -1e30F : 1e30F;
             lut.cube->nodes[i] = {v, -v, v};
         }
         return lut;
     }},
    {"largest", "an identity whose white is the largest float", 3.4028235e38,
     [] {
         Lut lut;
         lut.cube = identity_cube(2);
         lut.cube->at(1, 1, 1) = {3.4028235e38F, 3.4028235e38F, 3.4028235e38F};
         return lut;
     }},
    {"denormal", "the input times 1e-40, below the smallest normal float", 1e-40,
     [] { return look_of(17, [](RgbD c) { return 1e-40 * c; }); }},
    {"size_2", "two nodes per axis, corners swapped and mixed", 1,
     [] {
         return look_of(2, [](RgbD c) {
             return RgbD{c.r * (1 - c.g), c.g + c.b - c.g * c.b, c.r * c.b};
         });
     }},
    {"size_129", "129 nodes per axis, a smooth contrast", 1.49991,
     [] { return look_of(129, each_channel(smooth)); }},
    {"domain_narrow", "a smooth contrast over 0..1e-6", 1.49854,
     [] {
         return look_of(33, each_channel(smooth), {{0, 0, 0}, {1e-6F, 1e-6F, 1e-6F}});
     }},
    {"domain_narrow_offset", "a smooth contrast over 0.5..0.500001, some 17 floats", 1.49854,
     [] {
         constexpr float top = 0.5F + 1e-6F;
         return look_of(33, each_channel(smooth), {{0.5F, 0.5F, 0.5F}, {top, top, top}});
     }},
    {"domain_wide", "a smooth contrast over -5e5..5e5", 1.49854,
     [] {
         return look_of(33, each_channel(smooth), {{-5e5F, -5e5F, -5e5F}, {5e5F, 5e5F, 5e5F}});
     }},
    {"spike", "an identity of 33 nodes with mid grey at 1", 17, [] { return with_spike(1); }},
    {"spike_100", "an identity of 33 nodes with mid grey at 100", 3185,
     [] { return with_spike(100); }},
    {"permuted", "red from green, green from blue, blue from red", 1,
     [] { return look_of(17, [](RgbD c) {
              return RgbD{c.g, c.b, c.r};
          }); }},
    {"swapped", "red and blue exchanged: the cube turned inside out", 1,
     [] { return look_of(17, [](RgbD c) {
              return RgbD{c.b, c.g, c.r};
          }); }},
    {"folded", "red folded over at 0.5: 0..1..0", 2,
     [] { return look_of(17, [](RgbD c) {
              return RgbD{1 - std::abs(2 * c.r - 1), c.g, c.b};
          }); }},
    {"inverted", "a photographic negative of every channel", 1,
     [] { return look_of(17, [](RgbD c) { return grey(1) - c; }); }},
    {"noise", "every node a random colour", 16, noise_look},
    {"shaped_log", "a steep logarithmic 1D table, then a cube that mixes channels", 147.75,
     [] {
         Lut lut;
         lut.shaper =
             curve_of(1024, [](double x) { return std::log1p(1000 * x) / std::log(1001); });
         lut.cube = cube_of(17, [](RgbD c) {
             const double y = luma(c);
             return grey(y) + 1.5 * (c - grey(y));
         });
         return lut;
     }},
}};

} // namespace

std::span<const StiffLook> stiff_suite() {
    return stiff_look_rows;
}

const StiffLook* stiff_look_named(std::string_view name) {
    return find_named(stiff_look_rows, name);
}

} // namespace lutlib
