// Where a window goes on the monitors. Plain: no window library.
#pragma once

#include "preview/gpu/size.h"

#include <span>

namespace preview {

/// A part of the desktop, in the window library's coordinates.
struct DesktopArea {
    int x = 0, y = 0, width = 0, height = 0;
    friend bool operator==(const DesktopArea&, const DesktopArea&) = default;
};

/// What the desktop draws about a window.
struct FrameWidths {
    int left = 0, top = 0, right = 0, bottom = 0;
};

/// Of a window that has never been opened: what it draws, of `usual` size in the middle of `work`,
/// less where it would not fit there with its frame.
DesktopArea first_area(Size usual, const FrameWidths& frame, const DesktopArea& work);

/// Of one that was there before: in the work area that has most of it (the first where none has
/// any), moved and made smaller so that it and its frame lie within. `works` may not be empty.
DesktopArea area_again(const DesktopArea& last, const FrameWidths& frame,
                       std::span<const DesktopArea> works);

} // namespace preview
