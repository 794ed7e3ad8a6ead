#include "preview/reference/magnify.h"

namespace preview::reference {

Image magnified(const Image& picture, const MagnifyPlace& place, bool is_smooth, double surround,
                int width, int height) {
    Image out(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double at_x = (x - place.left + 0.5) / place.scale,
                         at_y = (y - place.top + 0.5) / place.scale;
            const bool is_in =
                at_x >= 0 && at_x < picture.width && at_y >= 0 && at_y < picture.height;
            out.at(x, y) = !is_in      ? lutlib::RgbD{surround, surround, surround}
                           : is_smooth ? picture.sample(at_x, at_y)
                                       : picture.at(static_cast<int>(at_x), static_cast<int>(at_y));
        }
    }
    return out;
}

} // namespace preview::reference
