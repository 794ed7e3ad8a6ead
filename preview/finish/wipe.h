// How a picture is divided between two looks: by a line in any direction, or by a box. Plain: no
// GPU.
#pragma once

#include "preview/finish/compare.h"
#include "preview/gpu/size.h"

#include <array>
#include <cstdint>

namespace preview {

struct Wipe {
    float split = 0.5F;    ///< where the line stands, of the way across the picture
    float split_angle = 0; ///< degrees that the way is turned, clockwise; 0: A left, 90: A above
    float box_x = 0.3F, box_y = 0.3F; ///< of the box's upper left corner, of width and height
    float box_width = 0.4F, box_height = 0.4F; ///< likewise
    friend bool operator==(const Wipe&, const Wipe&) = default;
};

/// In texels, as shaders/common/wipe.glsl takes it: a line as its normal, which points to side B,
/// and its distance along it from the upper left; a box as its corners.
using WipeShape = std::array<float, 4>;

/// Of a picture of that size. The line's way goes from its first corner to its last in the line's
/// direction. Of a comparison that is not divided: a line.
WipeShape wipe_shape(const Wipe& wipe, const Compare& compare, Size size);
/// Of the same picture, `scale` as large and moved.
WipeShape placed(const WipeShape& shape, const Compare& compare, float left, float top,
                 float scale);
/// Whether the texel at this place (its middle at half integers) shows side A: twin of the shader.
bool shows_a(const WipeShape& shape, const Compare& compare, double x, double y);
/// The share of the line's way that is at a place of a picture of that size.
float split_at(float split_angle, float x, float y, Size size);

} // namespace preview
