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
/// How many versions are neither the recipe nor what its file has.
std::size_t unsaved_versions(const State& state);
/// Whether the window's end would lose work: the recipe's changes, or a version.
bool has_unsaved(const State& state);
/// A side shows the version there, beside what the other shows. Whether there is one.
bool show_version(State& state, std::size_t place, std::size_t side);

/// Where the comparison shows the other side alone, it is split.
void bring_to_view(State& state, std::size_t side);

} // namespace preview::editor
