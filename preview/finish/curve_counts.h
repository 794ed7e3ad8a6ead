// The axes of the operators' curves along which the colours of a picture are counted before the
// look, so that a curve can be drawn over what it will act on.
//
// Luminance is Oklab L, saturation Oklab chroma over .3225, hue the dial of lutlib/color/oklab.h,
// each of the codes read in the recipe's input encoding; the others are codes themselves. A hue
// counts by how much the hue curves act on its colour (hue_weight of lutlib/ops/secondary.h), in
// 64ths, so that neutrals have none; in the others each texel counts one. The primaries' hues, some
// of them multiples of a bin, lie in the middle of bins: bin i is about i * 360 / 128 degrees.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/ops/op.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace preview {

struct CountedAxis {
    std::string_view label;     ///< of a curve's axis
    std::string_view parameter; ///< the only parameter that it is for; empty: all with that axis
    double min, max;            ///< what lies beyond is not counted
};

/// In the order of the counts.
inline constexpr std::array<CountedAxis, 7> counted_axes{{
    {"luminance", "", 0, 1},
    {"saturation", "", 0, 1},
    {"hue", "", 0, 360},
    {"input", "master", 0, 1}, // luma, as the waveform has it
    {"input", "red", 0, 1},
    {"input", "green", 0, 1},
    {"input", "blue", 0, 1},
}};
inline constexpr std::uint32_t axis_bins = 128;
inline constexpr std::uint32_t hue_unit = 64;

/// The row for a curve parameter; null when its axis is not counted.
const CountedAxis* axis_for(const lutlib::Parameter& parameter);

/// How codes become the axes' values on the GPU: the storage block of shaders/axes.comp.
struct AxisTables {
    static constexpr std::size_t light_steps = 1024, dial_steps = 512;
    std::array<std::array<float, 4>, 3> cones{}; ///< linear light to Oklab's cones, by rows
    std::array<float, light_steps + 1> light{};  ///< of codes 0..1
    std::array<float, dial_steps + 1> dial{};    ///< of Oklab's angle from -pi to pi, rising
    std::array<float, 2> unused{};
};
AxisTables axis_tables(const lutlib::Encoding& encoding);

} // namespace preview
