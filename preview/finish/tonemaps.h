// Tone maps: from scene-linear light to display-encoded colour, as a table.
//
// Every row takes linear sRGB light after exposure and gives display-encoded 0..1, which is what a
// LUT expects. Light below 0 and NaN read as 0, light above 65504 (half floats end there) as 65504.
//
// A row that treats the channels apart is its curve and nothing else: shaders read that as a table
// (ToneCurve). One that mixes them names its twin in shaders/common/tonemap.glsl; the build writes
// the choice among those from this table (preview/shader_tables).
#pragma once

#include "lutlib/rgb.h"

#include <span>
#include <string_view>

namespace preview {

struct Tonemap {
    std::string_view name;
    std::string_view label; ///< with how its result is encoded for the display, where not as sRGB
    /// Of each channel by itself, for light of 0..65504; what it gives above 1 is clipped.
    double (*curve)(double light) = nullptr;
    /// Of colours of 0..65504, for a row without a curve, and the GLSL function that does the same.
    lutlib::RgbD (*mix)(lutlib::RgbD light) = nullptr;
    std::string_view shader = {};

    lutlib::RgbD apply(lutlib::RgbD light) const;
};

std::span<const Tonemap> tonemaps();
const Tonemap* tonemap_named(std::string_view name);
/// The row's place in the table, by which shaders know it.
int index_of(const Tonemap& row);

/// How a curve is tabulated: `nodes` evenly spaced values in each octave of light from 2^lowest on,
/// and one at the end, joined by straight lines. Light below reads as 2^lowest.
struct ToneCurve {
    static constexpr int lowest = -40, octaves = 56, nodes = 64;
    static constexpr int size = octaves * nodes + 1;
};

/// ToneCurve::size values of the row's curve, made once; empty for a row without one.
std::span<const float> tabulated_curve(const Tonemap& row);

} // namespace preview
