#include "lutlib/named.h"
#include "preview/effects/all.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace preview {

namespace {

constexpr auto effect_rows = std::to_array<const PostEffect*>({
    &effect::depth_of_field,
    &effect::chromatic_aberration,
    &effect::vignette,
    &effect::sharpen,
    &effect::pointillism,
    &effect::paintbrush,
    &effect::vaporwave,
    &effect::glitch,
    &effect::film_grain,
    &effect::fxaa,
});

constexpr StageInfo stage_rows[] = {
    {Stage::hdr, "hdr", "on light, before bloom"},
    {Stage::before_tonemap, "before tone map", "on light with its bloom"},
    {Stage::before_look, "before look", "on codes, before the looks"},
    {Stage::after_look, "after look", "on codes, after the looks"},
    {Stage::last, "last", "on the finished picture, after all other effects"},
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
    return effect_rows;
}

const PostEffect* post_effect_named(std::string_view name) {
    return lutlib::find_named(effect_rows, name);
}

EffectUse usual_use(const PostEffect& effect) {
    EffectUse out{&effect, {}, false};
    for (const lutlib::Parameter& parameter : effect.parameters) {
        out.values.push_back(lutlib::default_value(parameter));
    }
    return out;
}

std::uint32_t step_at(double seconds, double rate) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(seconds * rate)));
}

double strength_of(const EffectUse& use) {
    return std::get<double>(use.values.front());
}

Stage stage_of(const EffectUse& use) {
    const bool is_moved = use.before_look && can_stand_before_look(*use.effect);
    return is_moved ? Stage::before_look : use.effect->stage;
}

void set_number(EffectUse& use, std::string_view parameter, double value) {
    const std::span<const lutlib::Parameter> parameters = use.effect->parameters;
    const lutlib::Parameter* const found = lutlib::find_named(parameters, parameter);
    use.values[static_cast<std::size_t>(found - parameters.data())] = value;
}

bool can_stand_before_look(const PostEffect& effect) {
    return effect.stage == Stage::after_look;
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
    for (const PostEffect* effect : effect_rows) {
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
