// A part of a picture seen pixel by pixel, in double: twin of shaders/magnify.comp.
#pragma once

#include "preview/reference/image.h"

namespace preview::reference {

struct MagnifyPlace {
    int left = 0, top = 0; ///< of the picture's corner, in the output's pixels
    double scale = 1;      ///< the output's pixels to one of the picture
};

/// On a grey of that code; `is_smooth`: linear between texels, else the nearest.
Image magnified(const Image& picture, const MagnifyPlace& place, bool is_smooth, double surround,
                int width, int height);

} // namespace preview::reference
