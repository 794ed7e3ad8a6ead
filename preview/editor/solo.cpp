#include "preview/editor/solo.h"

namespace preview::editor {

lutlib::Recipe shown_recipe(const State& state) {
    lutlib::Recipe out = state.recipe;
    if (state.solo && *state.solo < out.operations.size()) {
        out.operations = {out.operations[*state.solo]};
        out.operations.front().enabled = true;
    }
    return out;
}

void toggle_bypass(State& state, std::size_t at) {
    bool& enabled = state.recipe.operations[at].enabled;
    enabled = !enabled;
}

void toggle_solo(State& state, std::size_t at) {
    state.solo = state.solo == at ? std::nullopt : std::optional(at);
}

void remove_operation(State& state, std::size_t at) {
    remove_operation(state.recipe, at);
    if (state.solo == at) {
        state.solo.reset();
    } else if (state.solo && *state.solo > at) {
        --*state.solo;
    }
}

void move_operation(State& state, std::size_t at, std::size_t to) {
    move_operation(state.recipe, at, to);
    if (state.solo) {
        state.solo = place_after_move(*state.solo, at, to);
    }
}

std::size_t place_after_move(std::size_t place, std::size_t at, std::size_t to) {
    if (place == at) {
        return to;
    }
    if (at < place && place <= to) {
        return place - 1;
    }
    return to <= place && place < at ? place + 1 : place;
}

} // namespace preview::editor
