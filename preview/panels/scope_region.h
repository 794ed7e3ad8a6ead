// The part of the picture that the scopes count, dragged with the mouse.
#pragma once

#include "preview/panels/seen.h"

namespace preview::panels {

/// While a region is to be dragged the picture takes the mouse for that. For the picture's last
/// item, with what is seen there. Whether it does.
bool takes_mouse_for_region(Ui& ui, const Seen& seen);

/// Draws the region's border over the picture, while scopes are seen that count it.
void show_scope_region(const Ui& ui, const Rect& area);

/// The panel's part: the buttons, and which region is counted.
void scope_region_controls(Ui& ui);

} // namespace preview::panels
