#include "preview/reference/vignette.h"

#include <numbers>

namespace preview::reference {

Image vignette(const Image& light, double strength, double angle) {
    // The lens stands over the middle, as far from the plane as the angle of view says.
    const double middle_x = light.width / 2.0, middle_y = light.height / 2.0;
    const double distance =
        std::hypot(middle_x, middle_y) / std::tan(angle / 2 * std::numbers::pi / 180);
    Image out(light.width, light.height);
    for (int y = 0; y < light.height; ++y) {
        for (int x = 0; x < light.width; ++x) {
            const double off_axis = std::hypot(x + 0.5 - middle_x, y + 0.5 - middle_y);
            const double cosine = std::cos(std::atan2(off_axis, distance));
            out.at(x, y) = light.at(x, y) * (1 - strength + strength * std::pow(cosine, 4));
        }
    }
    return out;
}

} // namespace preview::reference
