// A reference still: chosen, shown on a side, and what is made of it.
#pragma once

#include "preview/panels/ui.h"

namespace preview::panels {

/// Asks for the file of a picture, for that side.
void ask_for_still(Ui& ui, std::size_t side);
/// Reads it and shows it on that side. Throws lutlib::Error.
void open_still(Ui& ui, std::size_t side, const std::string& path);
/// How the side's still is shown.
void still_notes(Ui& ui, const Still& still, const std::string& place);
/// The part of the panel Versions.
void still_controls(Ui& ui);

/// Whether files that are dropped there become stills: on the panels, while Versions are seen.
bool takes_dropped_stills(const Ui& ui, float x, float y);

} // namespace preview::panels
