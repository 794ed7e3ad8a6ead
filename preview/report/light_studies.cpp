// What light and its shadows are made with: the g-buffer, shadow maps, area lights, surroundings
// and ambient occlusion.
#include "lutlib/error.h"
#include "preview/report/occlusion_truth.h"
#include "preview/report/study.h"
#include "preview/scene/surroundings.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace preview::report {

namespace {

constexpr std::string_view no_scene = "a picture has no surfaces";

void without_effects(Situation& s) {
    s.settings.effects.clear();
}

ImageHandle lit(Graph&, const FrameHandles& handles) {
    return handles.lit;
}

// Surfaces

std::string_view no_surfaces(const Situation& s) {
    return s.has_scene() ? "" : no_scene;
}

void prepare_surfaces(Situation& s) {
    without_effects(s);
    s.settings.without.set(Effect::occlusion, true); // it reads the g-buffer
}

std::vector<Variant> rasterisers(const Situation& situation, const StudyTools& tools) {
    std::vector<Variant> out;
    for (const RasterChoice& row : rasters().subspan(1)) {
        Raster raster{};
        try {
            raster = row.on(tools.renderer.device(), situation.settings.output);
        } catch (const lutlib::UsageError&) {
            continue; // not on this device
        }
        const std::string keeps =
            raster == Raster::forward ? "floats as they are interpolated" : "16-bit normals";
        out.push_back({fmt::format("{}, {}", row.name, keeps),
                       [raster](Situation& s) { s.settings.raster = raster; },
                       raster == situation.settings.raster});
    }
    return out;
}

bool draws_surfaces(std::string_view pass) {
    return pass == "g-buffer" || pass == "triangles" || pass == "large triangles" ||
           pass == "lighting" || pass == "forward" || pass == "background";
}

// Shadows

std::string_view no_shadows(const Situation& s) {
    const auto casts = [](const PointLight& light) { return light.is_on && light.casts_shadow; };
    return !s.has_scene() ? no_scene
           : s.settings.without.has(Effect::shadows) || s.settings.without.has(Effect::lights)
               ? "they are switched off"
           : std::none_of(s.lights.begin(), s.lights.end(), casts) &&
                   s.surroundings.kind != SurroundingsKind::sky
               ? "no light casts any"
               : "";
}

std::uint32_t usual_shadow_size(const Situation& s) {
    return s.settings.shadow_size > 0 ? s.settings.shadow_size : s.shown->scene->shadow_size;
}

/// Sizes with the filter that is asked for, and other filters of the usual size.
std::vector<Variant> shadow_maps(const Situation& situation, const StudyTools& tools) {
    std::vector<Variant> out{
        {"none", [](Situation& s) { s.settings.without.set(Effect::shadows, true); }}};
    for (std::uint32_t size = 128; size < tools.converged_shadow_size(); size *= 2) {
        out.push_back({fmt::format("{0}x{0}", size),
                       [size](Situation& s) { s.settings.shadow_size = size; },
                       size == usual_shadow_size(situation)});
    }
    for (const ShadowFilter& row : shadow_filters()) {
        if (&row != situation.settings.shadow_filter) {
            out.push_back(
                {fmt::format("{0}x{0}, {1} filter", usual_shadow_size(situation), row.name),
                 [&row](Situation& s) { s.settings.shadow_filter = &row; }});
        }
    }
    return out;
}

void converge_shadows(Situation& s, const StudyTools& tools) {
    s.settings.shadow_size = tools.converged_shadow_size();
}

// Area lights

bool is_area(const PointLight& light) {
    return light.is_on && !light.is_point() && !light.is_sun;
}

std::string_view no_area_lights(const Situation& s) {
    return !s.has_scene()                                            ? no_scene
           : s.settings.without.has(Effect::lights)                  ? "lights are switched off"
           : std::none_of(s.lights.begin(), s.lights.end(), is_area) ? "no light has an area"
                                                                     : "";
}

/// They are seen without their shadows, which are their middles'.
void prepare_area_lights(Situation& s) {
    without_effects(s);
    for (PointLight& light : s.lights) {
        light.casts_shadow = light.casts_shadow && !is_area(light);
    }
}

glm::vec3 across(glm::vec3 axis) {
    const glm::vec3 other = std::abs(axis.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    return glm::normalize(glm::cross(axis, other));
}

/// Place `i` of `count` on a light: along a rod, round a ring, spread over a ball (Vogel's spiral).
glm::vec3 place_on(const PointLight& light, int i, int count) {
    const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
    if (light.shape == PointLight::Shape::rod) {
        return light.position + light.extent * (2 * share - 1);
    }
    const float turn = 2 * std::numbers::pi_v<float>;
    if (light.shape == PointLight::Shape::ring) {
        const float radius = glm::length(light.extent);
        const glm::vec3 axis = radius > 0 ? light.extent / radius : glm::vec3(0, 1, 0);
        const glm::vec3 u = across(axis), v = glm::cross(axis, u);
        return light.position + radius * (std::cos(turn * share) * u + std::sin(turn * share) * v);
    }
    const float height = 2 * share - 1, width = std::sqrt(1 - height * height);
    const float angle = turn * 0.618034F * static_cast<float>(i);
    return light.position +
           light.thickness * glm::vec3(width * std::cos(angle), height, width * std::sin(angle));
}

void split_lights(Situation& s, int count) {
    std::vector<PointLight> out;
    for (const PointLight& light : s.lights) {
        if (!is_area(light)) {
            out.push_back(light);
            continue;
        }
        for (int i = 0; i < count; ++i) {
            PointLight part = light;
            part.position = place_on(light, i, count);
            part.intensity /= static_cast<float>(count);
            part.shape = PointLight::Shape::point;
            part.extent = glm::vec3(0);
            part.thickness = 0;
            out.push_back(part);
        }
    }
    s.lights = std::move(out);
}

std::vector<Variant> area_lights(const Situation&, const StudyTools&) {
    std::vector<Variant> out{{"closed form", [](Situation&) {}, true}};
    for (const int count : {1, 4, 16, 64}) {
        out.push_back({count == 1 ? "a point" : fmt::format("{} points", count),
                       [count](Situation& s) { split_lights(s, count); }, false, false});
    }
    return out;
}

// Surroundings

std::string_view no_surroundings(const Situation& s) {
    return !s.has_scene()                                ? no_scene
           : s.settings.without.has(Effect::environment) ? "they are switched off"
                                                         : "";
}

bool has_sky(const Situation& s) {
    return s.has_scene() && has_map(s.surroundings.kind);
}

/// Scenes without a map of them are seen under a sky.
void prepare_surroundings(Situation& s) {
    without_effects(s);
    if (!has_sky(s)) {
        s.surroundings.kind = SurroundingsKind::sky;
    }
}

std::vector<Variant> bases(const Situation&, const StudyTools& tools) {
    std::vector<Variant> out;
    for (std::uint32_t height = 8; height < tools.converged_surroundings().height; height *= 2) {
        const Size base{2 * height, height};
        out.push_back({fmt::format("{}x{}", base.width, base.height),
                       [base](Situation& s) { s.settings.surroundings_base = base; },
                       base == surroundings_base_size});
    }
    return out;
}

// Ambient occlusion

std::string_view no_occlusion(const Situation& s) {
    return !s.has_scene()                              ? no_scene
           : s.settings.without.has(Effect::occlusion) ? "it is switched off"
           : s.settings.raster == Raster::forward      ? "it needs the g-buffer"
           : s.settings.occlusion.strength <= 0        ? "its strength is 0"
           : s.shown->scene->occlusion <= 0            ? "the scene does not ask for it"
                                                       : "";
}

/// Numbers of directions at the resolution that is asked for, and that number at others.
std::vector<Variant> occlusions(const Situation& situation, const StudyTools&) {
    std::vector<Variant> out{
        {"none", [](Situation& s) { s.settings.without.set(Effect::occlusion, true); }}};
    for (const float samples : {1.0F, 2.0F, 4.0F, 8.0F, 16.0F, 32.0F, 64.0F}) {
        out.push_back({fmt::format("{} samples", samples),
                       [samples](Situation& s) { s.settings.occlusion.samples = samples; },
                       samples == situation.settings.occlusion.samples});
    }
    for (const OcclusionResolution& row : occlusion_resolutions()) {
        if (&row != situation.settings.occlusion.resolution) {
            out.push_back({fmt::format("{} samples, {} resolution",
                                       situation.settings.occlusion.samples, row.name),
                           [&row](Situation& s) { s.settings.occlusion.resolution = &row; }});
        }
    }
    return out;
}

} // namespace

const Study surface_study{
    .name = "surfaces",
    .title = "G-buffer",
    .help = "The rasterisers: two keep what the camera sees in a g-buffer with 16 bits for each of "
            "two numbers of a normal, one lights what it draws. The pass is the light of surfaces.",
    .reference = "Surfaces lit as they are drawn, from floats that nothing has stored.",
    .none_because = no_surfaces,
    .variants = rasterisers,
    .counts = draws_surfaces,
    .looked = {.result = lit},
    .prepare = prepare_surfaces,
    .is_budgeted = [](const Situation&) { return false; },
    .converge = [](Situation& s, const StudyTools&) { s.settings.raster = Raster::forward; }};

const Study shadow_study{
    .name = "shadows",
    .title = "Shadows",
    .help =
        "The side of each shadow map, and by how many texels of it shadows are averaged, three by "
        "three where nobody asks for others: they are as soft as the maps are coarse. The pass is "
        "the light of surfaces.",
    .reference = "Shadow maps of 4096 texels a side on a software device, 8192 on others.",
    .none_because = no_shadows,
    .variants = shadow_maps,
    .counts =
        [](std::string_view pass) {
            return pass.starts_with("shadow of ") || pass == "lighting" || pass == "forward";
        },
    .looked = {.result = lit},
    .prepare = without_effects,
    .converge = converge_shadows};

const Study area_light_study{
    .name = "area-lights",
    .title = "Area lights",
    .help = "Balls, rods and rings by their closed form, and as so many points each.",
    .reference = "Each light as 1024 points.",
    .none_because = no_area_lights,
    .variants = area_lights,
    .counts = [](std::string_view pass) { return pass == "lighting" || pass == "forward"; },
    .looked = {.result = lit},
    .prepare = prepare_area_lights,
    .is_budgeted = [](const Situation&) { return false; },
    .converge = [](Situation& s, const StudyTools&) { split_lights(s, 1024); }};

const Study surroundings_study{
    .name = "surroundings",
    .title = "Sky and environment",
    .help = "The size of the map of all directions from which rough surfaces take light. A scene "
            "without one is seen under a sky.",
    .reference = "A map of 128x64 on a software device, 256x128 on others.",
    .none_because = no_surroundings,
    .variants = bases,
    .counts =
        [](std::string_view pass) {
            return pass.starts_with("surroundings") || pass == "reflectance";
        },
    .looked = {.result = lit},
    .prepare = prepare_surroundings,
    .is_budgeted = has_sky,
    .converge =
        [](Situation& s, const StudyTools& tools) {
            s.settings.surroundings_base = tools.converged_surroundings();
        }};

const Study occlusion_study{
    .name = "occlusion",
    .title = "Ambient occlusion",
    .help = "Directions in which a cell of pixels, two by two where nobody asks for others, looks "
            "for what hides the surroundings; what stays with many of them comes of the resolution "
            "and its blur.",
    .reference = "Every pixel by itself in double, from 1024 directions (256 of more than 100,000 "
                 "pixels), and the frame lit by that.",
    .none_because = no_occlusion,
    .variants = occlusions,
    .truth = occlusion_truth,
    .counts = [](std::string_view pass) { return pass.starts_with("ambient occlusion"); },
    .looked = {.result = [](Graph&, const FrameHandles& handles) { return handles.occlusion; }},
    .prepare = without_effects,
    .is_truth_slow = true,
    .converge = [](Situation& s, const StudyTools&) { s.settings.occlusion.samples = 1024; }};

} // namespace preview::report
