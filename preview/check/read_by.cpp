#include "preview/check/read_by.h"

namespace preview {

namespace {

reference::Image image_of(std::span<const float> rgba, Size size) {
    reference::Image out(static_cast<int>(size.width), static_cast<int>(size.height));
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.pixels[i][c] = static_cast<double>(rgba[4 * i + c]);
        }
    }
    return out;
}

} // namespace

reference::Image image_of(const Observed& observed) {
    return image_of(observed.values, {observed.desc.width, observed.desc.height});
}

reference::Image image_of(const ShownPicture& picture) {
    return image_of(picture.rgba, picture.size);
}

} // namespace preview
