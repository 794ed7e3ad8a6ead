// The views of the finished picture in double; shaders/common/picture_views.glsl explains them.
#pragma once

#include "lutlib/rgb.h"
#include "preview/finish/picture_views.h"

namespace preview::reference {

/// A texel and what there is to know of it; as the shader's.
struct Viewed {
    lutlib::RgbD color{}, before{};
    int x = 0, y = 0;
    int unit = 1;
    double level = 1;
};

/// What a row shows of it, within 0..1. Throws std::out_of_range for a row that has no twin.
lutlib::RgbD picture_view(const PictureView& row, const Viewed& viewed);

} // namespace preview::reference
