#pragma once

namespace preview::panels {

/// A part of the window, in its pixels.
struct Rect {
    float x = 0, y = 0, width = 0, height = 0;
};

} // namespace preview::panels
