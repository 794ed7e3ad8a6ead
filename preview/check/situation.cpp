#include "preview/check/situation.h"

#include "preview/effects/effect.h"

#include <algorithm>

namespace preview {

Situation with_every_pass(Situation situation) {
    FrameSettings& settings = situation.settings;
    for (const PostEffect* const effect : post_effects()) {
        if (use_of(settings.effects, *effect) == nullptr) {
            put_use(settings.effects, usual_use(*effect));
        }
    }
    settings.force_all = true;
    settings.format = Format::rgba32f;
    settings.dithers = false;
    return situation;
}

namespace {

/// Of a copy, which becomes what is shown.
template <class Change>
void change_shown(Situation& situation, Change change) {
    auto shown = std::make_shared<Shown>(*situation.shown);
    change(*shown);
    situation.shown = std::move(shown);
}

} // namespace

Situation changed(const Situation& situation, const Extreme& row) {
    Situation out = situation;
    if (row.change_scene && out.shown->scene) {
        change_shown(out, [&](Shown& shown) { row.change_scene(*shown.scene); });
    }
    if (row.change_picture && out.shown->picture) {
        change_shown(out, [&](Shown& shown) { row.change_picture(*shown.picture); });
    }
    if (row.change) {
        row.change(out);
    }
    return out;
}

Situation changed(const Situation& situation, const Nudge& row, double share) {
    Situation out = situation;
    if (row.change_scene && out.shown->scene) {
        change_shown(out, [&](Shown& shown) { row.change_scene(*shown.scene, share); });
    }
    if (row.change) {
        row.change(out, share);
    }
    return out;
}

} // namespace preview
