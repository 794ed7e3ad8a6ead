#include "preview/window/opening.h"

#include "preview/effects/effect.h"
#include "preview/frame/shown.h"

namespace preview {

void take_shown(editor::State& state, std::shared_ptr<const Shown> shown) {
    set_usual(state.effects, shown->scene.has_value());
    state.lights.clear();
    if (shown->scene) {
        state.orbit = shown->scene->orbit;
        state.lights = shown->scene->lights;
    }
    state.picture.has_light = !shown->display_encoded();
    state.shown = std::move(shown);
}

} // namespace preview
