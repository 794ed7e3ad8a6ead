// Reference stills on the sides of the comparison.
#pragma once

#include "preview/editor/file_follower.h"

#include <cstddef>

namespace preview::editor {

/// The side shows the still beside what the other shows.
void show_still(State& state, std::size_t side, std::shared_ptr<const Still> still);
/// The side shows what it did before any still: no look on A, the recipe on B.
void take_still_off(State& state, std::size_t side);

/// The files of the stills that the state shows, as they are to be read again.
std::vector<FollowedFile> followed_stills(const State& state);

/// The file of a still is `fresh` now, in every state that has it.
void take_still(History& history, const std::shared_ptr<const Still>& fresh);

} // namespace preview::editor
