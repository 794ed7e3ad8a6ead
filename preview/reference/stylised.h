// Pictures that want to be no photographs, in double: twins of glitch.comp, vaporwave.comp and
// pointillism.comp, which explain them. Lengths in texels.
#pragma once

#include "preview/reference/image.h"

#include <cstdint>

namespace preview::reference {

struct Glitch {
    double green_shift = 0, tear = 0, torn_lines = 0, noise = 0;
    std::uint32_t moment = 0;
    int line = 1;
};
Image glitched(const Image& picture, const Glitch& glitch);

struct Vaporwave {
    double strength = 1, field = 1, moved = 0;
};
/// `is_background`: of each pixel, whether there is no surface.
Image vaporwave(const Image& picture, const std::vector<bool>& is_background,
                const Vaporwave& vaporwave);

struct Pointillism {
    double strength = 1, cell = 2;
    bool is_colored = true;
};
Image pointillism(const Image& picture, const Pointillism& pointillism);

} // namespace preview::reference
