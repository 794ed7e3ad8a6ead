// Versions of the look that a person stores to come back to, or to compare with.
#pragma once

#include "preview/editor/model.h"

#include <string>

namespace preview::editor {

/// What people call it: the title, else the operators that it has.
std::string name_of(const Version& version);

// `place` is below version_count.

/// The recipe becomes the version there, in place of another.
void store_version(State& state, std::size_t place);
/// The version becomes the recipe, which its file then has not. Whether there is one.
bool recall_version(State& state, std::size_t place);
/// A side shows the version there, beside what the other shows. Whether there is one.
bool show_version(State& state, std::size_t place, std::size_t side);

} // namespace preview::editor
