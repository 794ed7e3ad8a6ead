// Everything that can be done, found by typing (Ctrl+P): the actions of keys, and the rows of every
// table that a panel offers.
#pragma once

#include "preview/panels/actions.h"

#include <string>
#include <vector>

namespace preview::panels {

/// What the palette offers now, each with a text of its own.
std::vector<Action> commands(const Ui& ui);

/// The places in `all` of those that every word of `typed` is found in: first those that begin so,
/// then those with the words together, then the others, each in their order.
std::vector<std::size_t> found_commands(const std::vector<Action>& all, const std::string& typed);

/// Draws it while ui.shows_palette.
void palette(Ui& ui);

} // namespace preview::panels
