// The picture's part of the window, and what of the picture is seen there.
#pragma once

#include "preview/panels/ui.h"

namespace preview::panels {

struct Seen {
    Size own, output; ///< the picture's, and that of one side's part of the window
    Zoom zoom;        ///< as the frame takes it
    OutputPoint mouse;
    float left = 0, top = 0, scale = 1; ///< of the picture of one side, in the output's pixels
    Size whole;                         ///< the size that its comparison is told of
};

/// With the picture in that area.
Seen seen_in(const Ui& ui, const Rect& area);

/// The mouse in shares of the picture, where it is beyond it of its edge.
OutputPoint share_at_mouse(const Seen& seen);

} // namespace preview::panels
