#include "preview/check/read_by.h"

namespace preview {

reference::Image image_of(const Observed& observed) {
    reference::Image out(static_cast<int>(observed.desc.width),
                         static_cast<int>(observed.desc.height));
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.pixels[i][c] = static_cast<double>(observed.values[4 * i + c]);
        }
    }
    return out;
}

reference::Image image_of(const ShownPicture& picture) {
    reference::Image out(static_cast<int>(picture.size.width),
                         static_cast<int>(picture.size.height));
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.pixels[i][c] = static_cast<double>(picture.rgba[4 * i + c]);
        }
    }
    return out;
}

} // namespace preview
