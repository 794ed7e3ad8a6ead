// Picking a colour of the picture for a control.
#pragma once

#include "preview/panels/ui.h"

namespace preview::panels {

/// The next click on the picture picks for `use`, which gets the colour as soon as a frame has
/// measured it; `words` say over the picture what it is for. In place of what was to be picked.
void start_pick(Ui& ui, std::string words, std::function<void(Ui& ui, const Probe& probe)> use);

/// A button that starts a pick, or ends the one that it started; `place` is its name for mark().
bool pick_button(Ui& ui, const std::string& label, const std::string& help,
                 const std::string& place);

/// Called in the picture's window, after the item that the mouse hits and with ui.pointer set:
/// whether the mouse belongs to a pick.
bool takes_mouse_for_pick(Ui& ui);

} // namespace preview::panels
