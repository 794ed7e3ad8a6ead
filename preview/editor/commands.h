// What the window does with files. Each command changes all or nothing and throws lutlib::Error.
#pragma once

#include "lutlib/io/look.h"
#include "preview/editor/model.h"

#include <string>

namespace preview::editor {

/// A recipe replaces the recipe; a LUT becomes the base of a new one. Side B shows it. `said` is
/// what the look was opened with in place of its own encodings.
void open_look(State& state, const lutlib::io::Look& look, const lutlib::LookEncodings& said = {});
/// The side shows another look, as a table.
void open_side(Side& side, const lutlib::io::Look& look, const lutlib::LookEncodings& said = {});

void save_recipe(History& history, const std::string& path);

/// The recipe as a strip for the engine of `side`, as `lutconv bake` makes it; what it lost.
std::string export_strip(const State& state, const Side& side, const std::string& path);
/// The recipe as a LUT in the format of the path's extension; what it lost.
std::string export_lut(const State& state, const std::string& path);

} // namespace preview::editor
