#include "preview/scene/light_controls.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace preview {

namespace {

float strongest(glm::vec3 v) {
    return std::max({v.x, v.y, v.z});
}

/// The intensity's largest component is the light's strength, and the rest its colour. A light
/// without either is white.
glm::vec3 color_of(const PointLight& light) {
    const float strength = strongest(light.intensity);
    return strength > 0 ? light.intensity / strength : glm::vec3(1);
}

void set_color(PointLight& light, glm::vec3 color) {
    if (strongest(color) > 0) {
        light.intensity = color * (strongest(light.intensity) / strongest(color));
    }
}

/// Keeps the direction, also of a light that is made a point.
void set_size(PointLight& light, glm::vec3 size) {
    constexpr float least = 1e-6F;
    const float now = glm::length(light.extent);
    const glm::vec3 along = now > 0 ? light.extent / now : glm::vec3(0, 1, 0);
    light.extent = along * std::max(size.x, least);
}

std::string_view no_reach(const PointLight& light, bool /*shadows_fall*/) {
    return light.is_sun ? "a sun has no reach" : "";
}

std::string_view no_shadow(const PointLight& /*light*/, bool shadows_fall) {
    return shadows_fall ? "" : "--without shadows switches every shadow off";
}

std::string_view no_shadow_map(const PointLight& light, bool shadows_fall) {
    return light.casts_shadow ? no_shadow(light, shadows_fall) : "it casts no shadow";
}

/// A sun shines towards what it is aimed at.
std::string_view no_aim(const PointLight& light, bool shadows_fall) {
    return light.is_sun                                      ? ""
           : light.casts_shadow && light.shadows_all_round() ? "its shadow falls all round"
                                                             : no_shadow_map(light, shadows_fall);
}

std::string_view no_angle(const PointLight& light, bool shadows_fall) {
    return light.is_sun ? "a sun's shadow map sees all that casts shadows"
                        : no_shadow_map(light, shadows_fall);
}

std::string_view no_size(const PointLight& light, bool /*shadows_fall*/) {
    return light.is_sun                              ? "a sun has no size"
           : light.shape == PointLight::Shape::point ? "it is neither a rod nor a ring"
                                                     : "";
}

std::string_view no_thickness(const PointLight& light, bool /*shadows_fall*/) {
    return light.is_sun ? "a sun has no thickness" : "";
}

using Kind = LightControl::Kind;

constexpr float least_intensity = 1e-4F, most_intensity = 1e10F;
constexpr float farthest = 1000;

const LightControl rows[] = {
    {"on", "On", "whether it shines", "", Kind::flag, 0, 1, false,
     [](const PointLight& light) { return glm::vec3(light.is_on ? 1 : 0, 0, 0); },
     [](PointLight& light, glm::vec3 v) { light.is_on = v.x != 0; }},
    {"intensity", "Intensity", "of its strongest channel, radiance times m^2; a sun's irradiance",
     "radiance times m^2", Kind::number, least_intensity, most_intensity, true,
     [](const PointLight& light) { return glm::vec3(strongest(light.intensity), 0, 0); },
     [](PointLight& light, glm::vec3 v) { light.intensity = color_of(light) * v.x; }},
    {"color", "Colour", "linear sRGB; its intensity stays", "linear sRGB", Kind::color, 0, 1, false,
     color_of, set_color},
    {"position", "Position", "metres", "m", Kind::point, -farthest, farthest, false,
     [](const PointLight& light) { return light.position; },
     [](PointLight& light, glm::vec3 v) { light.position = v; }},
    {"reach", "Reach", "where it has faded to nothing, metres; 0: it reaches everywhere", "m",
     Kind::number, 0, farthest, false,
     [](const PointLight& light) { return glm::vec3(light.reach, 0, 0); },
     [](PointLight& light, glm::vec3 v) { light.reach = v.x; }, no_reach},
    {"size", "Size", "half the length of a rod, the radius of a ring, metres; 0: a point", "m",
     Kind::number, 0, 10, false,
     [](const PointLight& light) { return glm::vec3(glm::length(light.extent), 0, 0); }, set_size,
     no_size},
    {"thickness", "Thickness",
     "the radius of a ball, of a rod or of a ring's tube, metres; 0: as thin as a point or line",
     "m", Kind::number, 0, 10, false,
     [](const PointLight& light) { return glm::vec3(light.thickness, 0, 0); },
     [](PointLight& light, glm::vec3 v) { light.thickness = v.x; }, no_thickness},
    {"shadow", "Casts a shadow", "whether objects block its light", "", Kind::flag, 0, 1, false,
     [](const PointLight& light) { return glm::vec3(light.casts_shadow ? 1 : 0, 0, 0); },
     [](PointLight& light, glm::vec3 v) { light.casts_shadow = v.x != 0; }, no_shadow},
    {"aim", "Shadow's aim", "the middle of what its shadow map sees, metres", "m", Kind::point,
     -farthest, farthest, false, [](const PointLight& light) { return light.aim; },
     [](PointLight& light, glm::vec3 v) { light.aim = v; }, no_aim},
    {"angle", "Shadow's angle",
     "what its shadow map sees, degrees; no shadow falls outside. Over 170: all round, by six maps",
     "degrees", Kind::number, 1, PointLight::all_round, false,
     [](const PointLight& light) { return glm::vec3(light.shadow_angle, 0, 0); },
     [](PointLight& light, glm::vec3 v) { light.shadow_angle = v.x; }, no_angle},
};

} // namespace

std::span<const LightControl> light_controls() {
    return rows;
}

std::string_view idle_because(const LightControl& control, const PointLight& light,
                              bool shadows_fall) {
    if (!light.is_on && control.name != "on") {
        return "it is switched off";
    }
    if (strongest(light.intensity) == 0 && control.name != "intensity") {
        return "its intensity is 0";
    }
    return control.idle_because != nullptr ? control.idle_because(light, shadows_fall) : "";
}

std::string light_name(const PointLight& light, std::size_t index) {
    return light.name.empty() ? std::to_string(index) : light.name;
}

} // namespace preview
