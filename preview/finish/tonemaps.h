// Tone maps: from scene-linear light to display-encoded colour, as a table. Each row has a twin in
// shaders/common/tonemap.glsl under the same number.
//
// Every row takes linear sRGB light after exposure and gives display-encoded 0..1, which is what a
// LUT expects. Light below 0 and NaN read as 0, light above 65504 (half floats end there) as 65504.
#pragma once

#include "lutlib/rgb.h"

#include <span>
#include <string_view>

namespace preview {

struct Tonemap {
    std::string_view name;
    std::string_view label;
    std::string_view encoding; ///< how its result is encoded for the display
    int shader;                ///< TONEMAP in the shaders
    lutlib::RgbD (*apply)(lutlib::RgbD light);
};

std::span<const Tonemap> tonemaps();
const Tonemap* tonemap_named(std::string_view name);

/// IEC 61966-2-1: display-encoded value of linear 0..1.
double srgb_encode(double linear);
/// IEC 61966-2-1: linear value of display-encoded 0..1.
double srgb_decode(double encoded);

} // namespace preview
