#include "preview/editor/stills.h"

#include "preview/editor/versions.h"

#include <utility>

namespace preview::editor {

void show_still(State& state, std::size_t side, std::shared_ptr<const Still> still) {
    state.sides[side].still = std::move(still);
    state.sides[side].source = SideSource::still;
    bring_to_view(state, side);
}

void take_still_off(State& state, std::size_t side) {
    state.sides[side].still.reset();
    if (state.sides[side].source == SideSource::still) {
        state.sides[side].source = side == 0 ? SideSource::none : SideSource::recipe;
    }
}

std::vector<FollowedFile> followed_stills(const State& state) {
    std::vector<FollowedFile> out;
    for (const Side& side : state.sides) {
        if (!side.still) {
            continue;
        }
        const std::string& path = side.still->path;
        const std::string said = side.still->said ? side.still->said->name() : "";
        out.push_back(
            {"still " + said + " " + path, {path}, [path, said = side.still->said]() -> PutInPlace {
                 return [fresh = load_still(path, said)](History& history) {
                     take_still(history, fresh);
                     return nullptr;
                 };
             }});
    }
    return out;
}

void take_still(History& history, const std::shared_ptr<const Still>& fresh) {
    history.change_all([&](State& state) {
        for (Side& side : state.sides) {
            if (side.still && side.still->path == fresh->path && side.still->said == fresh->said) {
                side.still = fresh;
            }
        }
    });
}

} // namespace preview::editor
