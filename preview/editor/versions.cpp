#include "preview/editor/versions.h"

#include <algorithm>
#include <memory>

namespace preview::editor {

std::string name_of(const Version& version) {
    const lutlib::Recipe& recipe = version.recipe;
    if (!recipe.title.empty()) {
        return recipe.title;
    }
    std::string out;
    for (const lutlib::Operation& operation : recipe.operations) {
        if (operation.enabled) {
            out += (out.empty() ? "" : ", ") + std::string(operation.op->label);
        }
    }
    return out.empty() ? (recipe.base_lut ? "the base alone" : "no operators") : out;
}

void store_version(State& state, std::size_t place) {
    state.versions[place] =
        std::make_shared<const Version>(Version{state.recipe, state.base_path, state.told});
}

bool recall_version(State& state, std::size_t place) {
    const std::shared_ptr<const Version> version = state.versions[place];
    if (!version) {
        return false;
    }
    state.recipe = version->recipe;
    state.solo.reset();
    state.base_path = version->base_path;
    state.told = version->told;
    return true;
}

std::size_t unsaved_versions(const State& state) {
    return static_cast<std::size_t>(
        std::count_if(state.versions.begin(), state.versions.end(), [&](const auto& version) {
            return version && !same(version->recipe, state.recipe) &&
                   !same(version->recipe, state.saved);
        }));
}

bool has_unsaved(const State& state) {
    return is_unsaved(state) || unsaved_versions(state) > 0;
}

bool show_version(State& state, std::size_t place, std::size_t side) {
    if (!state.versions[place]) {
        return false;
    }
    state.sides[side].source = SideSource::version;
    state.sides[side].version = state.versions[place];
    state.sides[side].version_place = place;
    bring_to_view(state, side);
    return true;
}

void bring_to_view(State& state, std::size_t side) {
    const bool is_other_alone =
        side == 0 ? state.compare == &compare_b : state.compare == &compare_a;
    if (is_other_alone) {
        state.compare = &compare_split;
    }
}

} // namespace preview::editor
