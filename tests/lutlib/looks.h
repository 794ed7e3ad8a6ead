// A few looks as functions, from harmless to rude, for tests that must hold for any look.
#pragma once

#include "lutlib/lut.h"
#include "lutlib/transform.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lutlib {

struct TestLook {
    const char* name;
    RgbD (*f)(RgbD);

    Transform transform() const { return Transform::each(f); }
};

inline double test_luma(RgbD c) {
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

inline std::vector<TestLook> test_looks() {
    return {
        {"identity", [](RgbD c) { return c; }},
        {"saturated",
         [](RgbD c) {
             const double y = test_luma(c);
             return saturate(RgbD{y + 1.8 * (c.r - y), y + 1.8 * (c.g - y), y + 1.8 * (c.b - y)});
         }},
        {"muted_warm",
         [](RgbD c) {
             const double y = test_luma(c);
             return RgbD{0.1 + 0.8 * (y + 0.5 * (c.r - y)), 0.05 + 0.8 * (y + 0.5 * (c.g - y)),
                         0.7 * (y + 0.5 * (c.b - y))};
         }},
        {"contrast",
         [](RgbD c) {
             const auto s = [](double x) { return x * x * (3 - 2 * x); };
             return RgbD{s(c.r), s(c.g), s(c.b)};
         }},
        {"clipped",
         [](RgbD c) {
             return saturate(RgbD{2 * c.r - 0.5, 2 * c.g - 0.5, 2 * c.b - 0.5});
         }},
    };
}

/// The look at the nodes of a lattice over 0..1.
inline Lut3D sampled(RgbD (*f)(RgbD), int size) {
    Lut3D cube = identity_cube(size);
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r) {
                cube.at(r, g, b) = to_float(f(node_position(cube, r, g, b)));
            }
        }
    }
    return cube;
}

} // namespace lutlib
