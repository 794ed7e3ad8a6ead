#include "preview/window/opening.h"

#include "preview/effects/effect.h"
#include "preview/frame/shown.h"
#include "preview/frame/usual_finish.h"

namespace preview {

void take_shown(editor::State& state, std::shared_ptr<const Shown> shown) {
    // A finish that nobody chose follows what is shown.
    const UsualFinish before = usual_finish(state.shown ? state.shown->name : std::string());
    const UsualFinish usual = usual_finish(shown->name);
    if (state.tonemap == before.tonemap) {
        state.tonemap = usual.tonemap;
    }
    if (state.bloom == before.bloom) {
        state.bloom = usual.bloom;
    }
    set_usual(state.effects, shown->scene && usual.is_antialiased);
    state.lights.clear();
    state.surroundings = {};
    if (shown->scene) {
        state.orbit = shown->scene->orbit;
        state.lights = shown->scene->lights;
        state.surroundings = shown->scene->surroundings;
    }
    state.picture.has_light = !shown->display_encoded();
    state.shown = std::move(shown);
}

void take_shown_again(editor::State& state, const std::shared_ptr<const Shown>& fresh) {
    const std::optional<Scene>& before = state.shown->scene;
    if (fresh->scene && before && state.lights == before->lights) {
        state.lights = fresh->scene->lights;
    }
    state.picture.has_light = !fresh->display_encoded();
    state.shown = fresh;
}

} // namespace preview
