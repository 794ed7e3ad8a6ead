// Which pixels of a small picture go to which of the window's.
#pragma once

#include "preview/gpu/size.h"
#include "preview/panels/thumbnail.h"

#include <cstdint>

namespace preview {

struct PixelBox {
    std::int32_t left = 0, top = 0, right = 0, bottom = 0;
    friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

struct ThumbnailPlace {
    PixelBox from, to; ///< of the picture, of the window
    bool is_empty() const { return to.right <= to.left || to.bottom <= to.top; }
};

/// Pixels of a window to its coordinates.
struct FramebufferScale {
    float x = 1, y = 1;
};

/// What of it is within its clip and a window of `target` pixels.
ThumbnailPlace place_in(const panels::PlacedThumbnail& placed, FramebufferScale scale, Size picture,
                        Size target);

} // namespace preview
