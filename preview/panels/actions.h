// Everything that a key does, as a table: the keys, and their list (F1), follow it.
#pragma once

#include "preview/panels/ui.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace preview::panels {

struct Action {
    std::string help; ///< what it does
    Key key = Key::none;
    bool ctrl = false, shift = false;
    std::function<void(Ui& ui)> act;
    /// How the list calls its keys, where not by keys_of(); empty: the row before has it too.
    std::optional<std::string> listed{};
};

const std::vector<Action>& actions();

/// A line of the list that F1 shows.
struct HelpRow {
    std::string keys, help;
};
/// Every action with its keys, then what else keys and the mouse do.
std::vector<HelpRow> help_rows();

/// The action's keys as people read them: "Ctrl+Shift+Z".
std::string keys_of(const Action& action);
/// Whether this press asks for the action.
bool is_asked_by(const Action& action, const KeyPress& press);

} // namespace preview::panels
