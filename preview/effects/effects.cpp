#include "lutlib/named.h"
#include "preview/effects/all.h"

#include <algorithm>
#include <array>

namespace preview {

namespace {

constexpr auto table = std::to_array<const PostEffect*>({
    &effect::fxaa,
    &effect::vignette,
});

constexpr StageInfo stage_rows[] = {
    {Stage::hdr, "hdr", "on light, before bloom"},
    {Stage::before_tonemap, "before tone map", "on light with its bloom"},
    {Stage::after_look, "after look", "on the finished picture"},
};

auto find(EffectUses& uses, const PostEffect& effect) {
    return std::find_if(uses.begin(), uses.end(),
                        [&](const EffectUse& use) { return use.effect == &effect; });
}

} // namespace

std::span<const StageInfo> stages() {
    return stage_rows;
}

std::span<const PostEffect* const> post_effects() {
    return table;
}

const PostEffect* post_effect_named(std::string_view name) {
    return lutlib::find_named(table, name);
}

EffectUse usual_use(const PostEffect& effect) {
    EffectUse out{&effect, {}};
    for (const lutlib::Parameter& parameter : effect.parameters) {
        out.values.push_back(lutlib::default_value(parameter));
    }
    return out;
}

double strength_of(const EffectUse& use) {
    return std::get<double>(use.values.front());
}

const EffectUse* use_of(const EffectUses& uses, const PostEffect& effect) {
    const auto found = std::find_if(uses.begin(), uses.end(),
                                    [&](const EffectUse& use) { return use.effect == &effect; });
    return found == uses.end() ? nullptr : &*found;
}

void put_use(EffectUses& uses, EffectUse use) {
    const auto found = find(uses, *use.effect);
    if (found == uses.end()) {
        uses.push_back(std::move(use));
    } else {
        *found = std::move(use);
    }
}

void take_out(EffectUses& uses, const PostEffect& effect) {
    if (const auto found = find(uses, effect); found != uses.end()) {
        uses.erase(found);
    }
}

void set_usual(EffectUses& uses, bool is_scene) {
    for (const PostEffect* effect : table) {
        if (!effect->usual_for_scenes) {
            continue;
        }
        if (!is_scene) {
            take_out(uses, *effect);
        } else if (use_of(uses, *effect) == nullptr) {
            uses.insert(uses.begin(), usual_use(*effect));
        }
    }
}

} // namespace preview
