// What film and lenses add to a picture, in double: twins of film_grain.comp,
// chromatic_aberration.comp and sharpen.comp, which explain them. Lengths in texels.
#pragma once

#include "preview/reference/image.h"

#include <cstdint>

namespace preview::reference {

struct Grain {
    double amplitude = 0, cell = 1;
    std::uint32_t frame = 0;
    bool is_colored = false;
};
Image film_grain(const Image& picture, const Grain& grain);

/// `corner`: how far red and blue are from green in a corner.
Image chromatic_aberration(const Image& light, double corner);

Image sharpened(const Image& picture, double strength, int reach);

} // namespace preview::reference
