// One operator seen alone, and changes of the list of operators that keep it the one that is seen.
#pragma once

#include "preview/editor/model.h"

namespace preview::editor {

/// The recipe that is shown: all of it, or with the operator `state.solo` alone, even where that
/// is bypassed. Base and encodings stay.
lutlib::Recipe shown_recipe(const State& state);

// `at` and `to` are places of operators in the recipe.

/// Leaves the operator out, or takes it in again.
void toggle_bypass(State& state, std::size_t at);
/// Shows the operator alone, or everything again.
void toggle_solo(State& state, std::size_t at);
void remove_operation(State& state, std::size_t at);
void move_operation(State& state, std::size_t at, std::size_t to);

/// Where what stood at `place` stands after the operator `at` was moved `to`.
std::size_t place_after_move(std::size_t place, std::size_t at, std::size_t to);

} // namespace preview::editor
