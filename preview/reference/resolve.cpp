#include "preview/reference/resolve.h"

namespace preview::reference {

namespace {

using lutlib::RgbD;

RgbD held_light(const RgbD& light, double exposure) {
    RgbD out;
    for (std::size_t c = 0; c < 3; ++c) {
        const double v = light[c] * exposure;
        out[c] = v > 0 ? std::min(v, 65504.0) : 0; // NaN too
    }
    return out;
}

/// The mean over [low_x, high_x] x [low_y, high_y], which goes on as border texels.
RgbD mean_over(const Image& light, double exposure, double low_x, double high_x, double low_y,
               double high_y) {
    RgbD sum;
    const auto overlap = [](int texel, double low, double high) {
        return std::max(std::min(texel + 1.0, high) - std::max<double>(texel, low), 0.0);
    };
    for (int y = static_cast<int>(std::floor(low_y)); y < high_y; ++y) {
        for (int x = static_cast<int>(std::floor(low_x)); x < high_x; ++x) {
            sum = sum + held_light(light.clamped(x, y), exposure) *
                            (overlap(x, low_x, high_x) * overlap(y, low_y, high_y));
        }
    }
    return sum * (1 / ((high_x - low_x) * (high_y - low_y)));
}

} // namespace

Image resolved(const Image& light, double exposure, int width, int height,
               const ResolvePlace& inner) {
    Image out(width, height);
    const bool is_resized = width != light.width || height != light.height;
    const double scale_x = static_cast<double>(light.width) / inner.width,
                 scale_y = static_cast<double>(light.height) / inner.height;
    const double reach_x = std::max(scale_x, 1.0) / 2, reach_y = std::max(scale_y, 1.0) / 2;
    for (int y = 0; y < inner.height; ++y) {
        for (int x = 0; x < inner.width; ++x) {
            const double at_x = (x + 0.5) * scale_x, at_y = (y + 0.5) * scale_y;
            out.at(inner.x + x, inner.y + y) =
                is_resized ? mean_over(light, exposure, at_x - reach_x, at_x + reach_x,
                                       at_y - reach_y, at_y + reach_y)
                           : held_light(light.at(x, y), exposure);
        }
    }
    return out;
}

} // namespace preview::reference
