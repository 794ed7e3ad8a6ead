// The rows of values that are moved by one part in a million.
#include "preview/check/situation.h"

#include <cmath>
#include <numbers>

namespace preview {

namespace {

constexpr float scaled(float value, double share) {
    return static_cast<float>(static_cast<double>(value) * (1 + share));
}

float degrees(double radians) {
    return static_cast<float>(radians * 180 / std::numbers::pi);
}

template <class Change>
void for_each_light(Situation& situation, Change change) {
    for (PointLight& light : situation.lights) {
        change(light);
    }
}

/// Scales one of the picture's numbers, or what stands for it.
void scale(Situation& situation, std::string_view flag, double share) {
    const NumberRow<PictureSettings>& row = picture_number(flag);
    row.of(situation.settings) = scaled(row.value(situation.settings), share);
}

// What a row means something for.
bool anything(const Situation&) {
    return true;
}
bool any_light(const Situation& s) {
    return s.has_light();
}
bool any_scene(const Situation& s) {
    return s.has_scene();
}
bool any_lights(const Situation& s) {
    return s.has_scene() && !s.lights.empty();
}
bool any_sky(const Situation& s) {
    return s.has_scene() && s.surroundings.kind == SurroundingsKind::sky;
}

struct NudgeRow {
    std::string_view name, help;
    bool (*is_for)(const Situation& situation);
    void (*change)(Situation& situation, double share) = nullptr;
    void (*change_scene)(Scene& scene, double share) = nullptr;
    bool moves_geometry = false;
};
constexpr NudgeRow nudge_rows[] = {
    {"exposure", "of the light", anything,
     [](Situation& s, double share) {
         s.settings.exposure += static_cast<float>(std::log2(1 + share));
     }},
    {"bloom strength", "scaled", any_light,
     [](Situation& s, double share) { scale(s, "bloom-strength", share); }},
    {"bloom threshold", "scaled", any_light,
     [](Situation& s, double share) { scale(s, "bloom-threshold", share); }},
    {"bloom radius", "scaled", any_light,
     [](Situation& s, double share) { scale(s, "bloom-radius", share); }},
    {"occlusion strength", "scaled", any_scene,
     [](Situation& s, double share) { scale(s, "occlusion-strength", share); }},
    {"occlusion radius", "scaled", any_scene,
     [](Situation& s, double share) { scale(s, "occlusion-radius", share); }},
    {"lights' intensity", "scaled", any_lights,
     [](Situation& s, double share) {
         for_each_light(
             s, [&](PointLight& light) { light.intensity *= static_cast<float>(1 + share); });
     }},
    {"lights' position", "1e-6 m along x", any_lights,
     [](Situation& s, double share) {
         for_each_light(s,
                        [&](PointLight& light) { light.position.x += static_cast<float>(share); });
     }},
    {"azimuth", "1e-6 radians", any_scene,
     [](Situation& s, double share) { s.settings.orbit.azimuth += degrees(share); }, nullptr, true},
    {"elevation", "1e-6 radians", any_scene,
     [](Situation& s, double share) { s.settings.orbit.elevation += degrees(share); }, nullptr,
     true},
    {"roll", "1e-6 radians", any_scene,
     [](Situation& s, double share) { s.settings.orbit.roll += degrees(share); }, nullptr, true},
    {"distance", "scaled", any_scene,
     [](Situation& s, double share) {
         s.settings.orbit.distance = scaled(s.settings.orbit.distance, share);
     },
     nullptr, true},
    {"field of view", "scaled", any_scene,
     [](Situation& s, double share) {
         s.settings.orbit.field_of_view = scaled(s.settings.orbit.field_of_view, share);
     },
     nullptr, true},
    {"roughness", "of every material, scaled", any_scene, nullptr,
     [](Scene& scene, double share) {
         for (Material& material : scene.materials) {
             material.roughness = scaled(material.roughness, share);
         }
     }},
    {"albedo", "of every material, scaled", any_scene, nullptr,
     [](Scene& scene, double share) {
         for (Material& material : scene.materials) {
             material.albedo *= static_cast<float>(1 + share);
         }
     }},
    {"objects' position", "1e-6 m along x", any_scene, nullptr,
     [](Scene& scene, double share) {
         for (Object& object : scene.objects) {
             object.transform[3].x += static_cast<float>(share);
         }
     },
     true},
    {"sun's height", "1e-6 radians", any_sky,
     [](Situation& s, double share) { s.surroundings.sky.sun_height += degrees(share); }},
    {"turbidity", "scaled", any_sky,
     [](Situation& s, double share) {
         s.surroundings.sky.turbidity = scaled(s.surroundings.sky.turbidity, share);
     }},
    {"time", "a microsecond", anything,
     [](Situation& s, double share) {
         s.settings.seconds += share;
         s.surroundings.seconds += share;
     }},
};

} // namespace

std::vector<Nudge> nudges(const Situation& situation) {
    std::vector<Nudge> out;
    for (const NudgeRow& row : nudge_rows) {
        if (row.is_for(situation)) {
            out.push_back({std::string(row.name), std::string(row.help), row.change,
                           row.change_scene, row.moves_geometry});
        }
    }
    return out;
}

} // namespace preview
