// The ways in which a baked picture goes wrong that have names.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/engine/engine.h"
#include "lutlib/verify/diagnose.h"

#include <span>
#include <string_view>

namespace lutlib {

/// How a picture with one mistake comes about: where a node is put, at which input the look is
/// sampled, what is done with the value, and how it becomes a code. As it stands: no mistake.
struct Mistake {
    std::string_view words;
    /// Of the node (r, g, b) in a picture of `width` pixels.
    Pixel (*pixel)(const Layout&, int n, int width, int r, int g,
                   int b) = [](const Layout& layout, int n, int width, int r, int g, int b) {
        return layout.pixel(n, width, r, g, b);
    };
    double (*input)(const Engine&, int i, int n) = [](const Engine& engine, int i, int n) {
        return engine.node_input(i, n);
    };
    RgbD (*value)(RgbD in, RgbD out) = [](RgbD, RgbD out) { return out; };
    /// Whether the code may come of a value, 0 to 1, known to within `tolerance`.
    bool (*agrees)(int code, double value, int maximum, double tolerance) = is_rounded;
};

/// A rule that more codes satisfy stands behind a stricter one that explains as much.
std::span<const Mistake> mistakes();

} // namespace lutlib
