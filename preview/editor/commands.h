// What the window does with files. Each command changes all or nothing and throws lutlib::Error.
#pragma once

#include "preview/editor/model.h"

#include <string>

namespace preview::ui {

/// Whether the file is a recipe or a LUT; otherwise it may be a picture to look at.
bool is_look_file(const std::string& path);

/// A recipe replaces the recipe; a LUT becomes the base of a new one. Side B shows it.
void open_look(State& state, const std::string& path);
/// The side shows another LUT file.
void open_side(Side& side, const std::string& path);

void save_recipe(State& state, const std::string& path);

/// The recipe as a strip for the engine of `side`, as `lutconv bake` makes it; what it lost.
std::string export_strip(const State& state, const Side& side, const std::string& path);
/// The recipe as a LUT in the format of the path's extension; what it lost.
std::string export_lut(const State& state, const std::string& path);

} // namespace preview::ui
