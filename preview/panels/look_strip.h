// The looks of a folder as a strip of small pictures under the picture, each what is shown under
// that look.
#pragma once

#include "preview/editor/look_folder.h"

#include <set>
#include <string>

namespace preview::panels {

struct Ui;
struct Rect;

struct LookStrip {
    bool is_open = false;
    std::string folder{};             ///< that somebody has chosen; empty: the look's own
    editor::LookFolder listing{};     ///< what is shown of it
    bool is_outdated = true;          ///< the folder has changed since
    std::set<std::string> no_looks{}; ///< names of files that turned out to be none
    std::string scrolled_to{};        ///< the look's file, when it was last brought into sight
};

/// How high it is; 0 while it is closed.
float look_strip_height(const Ui& ui);
void look_strip(Ui& ui, const Rect& area);

void toggle_look_strip(Ui& ui);
/// Opens the look after the one that is edited, or with a `step` of -1 the one before it, among
/// those of the strip's folder that can be read.
void open_look_beside(Ui& ui, int step);

} // namespace preview::panels
