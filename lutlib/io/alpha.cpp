#include "lutlib/io/alpha.h"

namespace lutlib::io {

LightOnly make_straight(FloatImage& image) {
    LightOnly out;
    if (!image.alpha || !image.premultiplied) {
        return out;
    }
    image.premultiplied = false;
    for (std::size_t i = 0; i < image.rgba.size() / 4; ++i) {
        float* const c = &image.rgba[4 * i];
        if (c[3] == 0 || c[3] != c[3]) {
            if (c[0] != 0 || c[1] != 0 || c[2] != 0) {
                out.emplace_back(i, Rgb{c[0], c[1], c[2]});
            }
            continue;
        }
        if (c[3] != 1) {
            for (std::size_t k = 0; k < 3; ++k) {
                c[k] /= c[3];
            }
        }
    }
    return out;
}

void premultiply(FloatImage& image, const LightOnly& light) {
    image.premultiplied = true;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        if (const float alpha = image.rgba[i + 3]; alpha != 1) {
            for (std::size_t k = 0; k < 3; ++k) {
                image.rgba[i + k] *= alpha;
            }
        }
    }
    for (const auto& [pixel, color] : light) {
        for (std::size_t k = 0; k < 3; ++k) {
            image.rgba[4 * pixel + k] = color[k];
        }
    }
}

} // namespace lutlib::io
