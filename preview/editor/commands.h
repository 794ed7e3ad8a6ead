// What the window does with files. Each command changes all or nothing and throws lutlib::Error.
#pragma once

#include "lutlib/io/look.h"
#include "preview/editor/model.h"

#include <string>

namespace preview::editor {

/// A recipe replaces the recipe; a LUT becomes the base of a new one. Side B shows it. `said` is
/// what the look was opened with in place of its own encodings.
void open_look(State& state, const lutlib::io::Look& look, const lutlib::LookEncodings& said = {});
/// The recipe that a window has kept at `path` for a person who has saved it nowhere; its base lies
/// wherever the person had it.
void open_kept(State& state, const std::string& path);
/// The side shows another look, as a table.
void open_side(Side& side, const lutlib::io::Look& look, const lutlib::LookEncodings& said = {});

/// What people call the look: the name of its recipe, else of its base, without folder and ending.
std::string look_name(const State& state);
/// "* look.json - lutpreview": whether there are changes that no file has, and of what.
std::string window_title(const State& state);

void save_recipe(History& history, const std::string& path);

/// The recipe as a strip for the engine of `side`, as `lutconv bake` makes it; what it lost.
std::string export_strip(const State& state, const Side& side, const std::string& path);
/// The strip's file in an engine's folder, named as the look is.
std::string strip_in(const std::string& folder, const State& state);
/// Whether a strip may be written over what is at `path` without asking: nothing, or a picture that
/// lutconv or lutpreview made, and not the one that the recipe starts from.
bool is_replaceable(const State& state, const std::string& path);

} // namespace preview::editor
