// The rows of extreme input, but for what is shown itself. Those of settings come from the
// settings' own tables: each at both ends of its range.
#include "preview/check/extreme_contents.h"
#include "preview/effects/effect.h"
#include "preview/frame/rasters.h"
#include "preview/scene/camera_settings.h"

#include <fmt/format.h>

#include <utility>

namespace preview {

namespace {

using Rows = std::vector<Extreme>;

void set_effect(Situation& situation, std::string_view name, std::string_view parameter,
                double value) {
    const PostEffect& effect = *post_effect_named(name);
    const EffectUse* const given = use_of(situation.settings.effects, effect);
    EffectUse use = given != nullptr ? *given : usual_use(effect);
    set_number(use, parameter, value);
    put_use(situation.settings.effects, std::move(use));
}

void put_light_at(Situation& s, glm::vec3 place) {
    for (PointLight& light : s.lights) {
        light.position = place;
    }
}

struct FrameRow {
    std::string_view name, help;
    bool needs_scene;
    void (*change)(Situation& situation);
};
constexpr FrameRow frame_rows[] = {
    {"as it is", "nothing changed", false, [](Situation&) {}},
    {"target of 1x1", "a single pixel", false,
     [](Situation& s) {
         s.settings.output = {1, 1};
     }},
    {"target of 8191x3", "odd, and wider than any screen", false,
     [](Situation& s) {
         s.settings.output = {8191, 3};
     }},
    {"target of 3x1023", "odd and narrow", false,
     [](Situation& s) {
         s.settings.output = {3, 1023};
     }},
    {"exposure -30 stops", "light of a billionth", false,
     [](Situation& s) { s.settings.exposure = -30; }},
    {"exposure +30 stops", "a billion times the light", false,
     [](Situation& s) { s.settings.exposure = 30; }},
    {"time 1e6 s", "eleven days", false,
     [](Situation& s) { s.settings.seconds = s.surroundings.seconds = 1e6; }},
    {"time -1e6 s", "eleven days before", false,
     [](Situation& s) { s.settings.seconds = s.surroundings.seconds = -1e6; }},
    {"drawn forward", "lit as it is drawn", true,
     [](Situation& s) { s.settings.raster = Raster::forward; }},
    {"drawn by the graphics hardware", "with a g-buffer", true,
     [](Situation& s) { s.settings.raster = Raster::hardware; }},
    {"drawn by compute shaders", "with a g-buffer", true,
     [](Situation& s) { s.settings.raster = Raster::compute; }},
    {"focus at infinity", "lens f/0.5", true,
     [](Situation& s) {
         set_effect(s, "depth-of-field", "focus", 1e9);
         set_effect(s, "depth-of-field", "aperture", 0.5);
     }},
    {"focus of 0", "on what is in the middle", true,
     [](Situation& s) { set_effect(s, "depth-of-field", "focus", 0); }},
    {"focus at a tenth of a millimetre", "nearer than a lens can", true,
     [](Situation& s) { set_effect(s, "depth-of-field", "focus", 1e-4); }},
    {"sun at the horizon", "of the sky", true,
     [](Situation& s) {
         s.surroundings.kind = SurroundingsKind::sky;
         s.surroundings.sky.sun_height = 0;
     }},
    {"sun below the horizon", "20 degrees, of the sky", true,
     [](Situation& s) {
         s.surroundings.kind = SurroundingsKind::sky;
         s.surroundings.sky.sun_height = -20;
     }},
    {"sun at the zenith", "of the sky", true,
     [](Situation& s) {
         s.surroundings.kind = SurroundingsKind::sky;
         s.surroundings.sky.sun_height = 90;
     }},
    {"turbidity 1", "less than the model knows", true,
     [](Situation& s) {
         s.surroundings.kind = SurroundingsKind::sky;
         s.surroundings.sky.turbidity = 1;
     }},
    {"turbidity 30", "more than the model knows", true,
     [](Situation& s) {
         s.surroundings.kind = SurroundingsKind::sky;
         s.surroundings.sky.turbidity = 30;
     }},
    {"sky +20 stops", "a sun of 1e11", true,
     [](Situation& s) {
         s.surroundings.kind = SurroundingsKind::sky;
         s.surroundings.exposure = 20;
     }},
    {"noise at 1e6 s", "far from its origin", true,
     [](Situation& s) {
         s.surroundings.kind = SurroundingsKind::noise;
         s.surroundings.seconds = 1e6;
     }},
    {"coincident lights", "every light twice at one place", true,
     [](Situation& s) { s.lights.insert(s.lights.end(), s.lights.begin(), s.lights.end()); }},
    {"lights in one point", "all of them, at the camera's target", true,
     [](Situation& s) { put_light_at(s, s.settings.orbit.target); }},
    {"lights at infinity", "1e30 m away", true,
     [](Situation& s) { put_light_at(s, glm::vec3(1e30F, 0, 0)); }},
    {"lights at their aim", "a spot or sun without a direction", true,
     [](Situation& s) {
         for (PointLight& light : s.lights) {
             light.position = light.aim;
         }
     }},
    {"lights of 1e30", "intensity", true,
     [](Situation& s) {
         for (PointLight& light : s.lights) {
             light.intensity = glm::vec3(1e30F);
         }
     }},
    {"lights with a reach", "a tenth of a millimetre of every other one, 1e20 m of the rest", true,
     [](Situation& s) {
         for (std::size_t i = 0; i < s.lights.size(); ++i) {
             s.lights[i].reach = i % 2 == 0 ? 1e-4F : 1e20F;
         }
     }},
    {"negative lights", "intensity -1", true,
     [](Situation& s) {
         for (PointLight& light : s.lights) {
             light.intensity = glm::vec3(-1);
         }
     }},
    {"no light", "neither lights nor surroundings", true,
     [](Situation& s) {
         s.lights.clear();
         s.settings.without.set(Effect::environment, true);
     }},
    {"grazing view", "the camera's axis along the ground", true,
     [](Situation& s) {
         s.settings.orbit.elevation = 0;
         s.settings.orbit.target.y = 0;
     }},
    {"camera within things", "at a tenth of a millimetre from its target", true,
     [](Situation& s) {
         s.settings.orbit.distance = 1e-4F;
         s.settings.orbit.near_plane = 1e-5F;
     }},
};

void add_frames(Rows& rows, bool has_scene) {
    for (const FrameRow& row : frame_rows) {
        if (has_scene || !row.needs_scene) {
            rows.push_back({.name = std::string(row.name),
                            .help = std::string(row.help),
                            .change = row.change});
        }
    }
}

// ---- settings at both ends of their ranges

constexpr auto both_ends = {std::pair{"least", false}, std::pair{"most", true}};

template <class S, class Of>
void add_numbers(Rows& rows, std::span<const NumberRow<S>> numbers, Of of, std::string_view help) {
    for (const NumberRow<S>& number : numbers) {
        for (const auto& [end, is_most] : both_ends) {
            const double value = is_most ? number.max : number.min;
            rows.push_back({.name = fmt::format("{} {}", number.flag, value),
                            .help = fmt::format("the {} that --help names{}", end, help),
                            .change = [&number, value, of](Situation& situation) {
                                number.of(of(situation)) = static_cast<float>(value);
                            }});
        }
    }
}

/// What of a scene is worked out more or less finely.
void add_light_filters(Rows& rows) {
    for (const std::string_view flag : {"shadow-filter", "occlusion-resolution"}) {
        const ChoiceRow<PictureSettings>& row = picture_choice(flag);
        const std::vector<Option> options = row.options();
        for (std::size_t i = 0; i < options.size(); ++i) {
            rows.push_back(
                {.name = fmt::format("{} {}", flag, options[i].name),
                 .help = std::string(options[i].text),
                 .change = [&row, i](Situation& situation) { row.choose(situation.settings, i); }});
        }
    }
}

void add_effects(Rows& rows, const Situation& situation) {
    for (const PostEffect* const effect : post_effects()) {
        if (effect->needs_depth && !situation.has_scene()) {
            continue;
        }
        for (const auto& [end, is_most] : both_ends) {
            rows.push_back({.name = fmt::format("{} at its {}", effect->name, end),
                            .help = "every parameter but its strength",
                            .change = [effect, most = is_most](Situation& changed) {
                                for (const lutlib::Parameter& parameter :
                                     effect->parameters.subspan(1)) {
                                    set_effect(changed, effect->name, parameter.name,
                                               most ? parameter.max : parameter.min);
                                }
                                set_effect(changed, effect->name, "strength", 1);
                            }});
        }
    }
}

void add_blooms(Rows& rows) {
    for (const Bloom& bloom : blooms()) {
        rows.push_back({.name = fmt::format("bloom {}", bloom.name),
                        .help = "all light blooms, all of it",
                        .change = [&bloom](Situation& situation) {
                            situation.settings.bloom = &bloom;
                            situation.settings.bloom_settings = {1, 0, 0, 1};
                        }});
    }
}

void add_tonemaps(Rows& rows) {
    for (const Tonemap& tonemap : tonemaps()) {
        rows.push_back({.name = fmt::format("tone map {}", tonemap.name),
                        .help = "at +10 stops",
                        .change = [&tonemap](Situation& situation) {
                            situation.settings.tonemap = &tonemap;
                            situation.settings.exposure = 10;
                        }});
    }
}

} // namespace

std::vector<Extreme> extremes(const Situation& situation) {
    Rows rows;
    add_frames(rows, situation.has_scene());
    if (situation.shown->picture) {
        add_pictures(rows);
    }
    add_numbers(
        rows, picture_numbers(), [](Situation& s) -> PictureSettings& { return s.settings; }, "");
    if (situation.has_light()) {
        add_blooms(rows);
        add_tonemaps(rows);
    }
    add_effects(rows, situation);
    if (situation.has_scene()) {
        add_light_filters(rows);
        add_scenes(rows);
        add_numbers(
            rows, camera_numbers(), [](Situation& s) -> Orbit& { return s.settings.orbit; }, "");
        for (const SurroundingsInfo& info : surroundings_kinds()) {
            if (info.kind == SurroundingsKind::picture && !situation.shown->surroundings) {
                continue;
            }
            add_numbers(
                rows, info.numbers,
                [kind = info.kind](Situation& s) -> Surroundings& {
                    s.surroundings.kind = kind;
                    return s.surroundings;
                },
                fmt::format(", of {}", info.name));
        }
    }
    return rows;
}

} // namespace preview
