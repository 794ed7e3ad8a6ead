// Everything that can be done, found by typing (Ctrl+P): the actions of keys, the panels, the rows
// of every choice, effects, scopes and parts of the frame.
#pragma once

#include "preview/panels/actions.h"

#include <string>
#include <vector>

namespace preview::panels {

/// What the palette offers, each with a text of its own.
std::vector<Action> commands();

/// The places in `all` of those that every word of `typed` is found in, in their order.
std::vector<std::size_t> found_commands(const std::vector<Action>& all, const std::string& typed);

/// Draws it while ui.shows_palette.
void palette(Ui& ui);

} // namespace preview::panels
