#include "preview/frame/declared_scene.h"

#include "preview/scene/gpu_scene.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace preview {

namespace {

/// The lights that reach the frame, named.
std::vector<PointLight> shining_lights(Graph& graph, const std::vector<PointLight>& lights,
                                       const FrameSettings& settings) {
    std::vector<PointLight> shining;
    if (settings.without.has(Effect::lights)) {
        return shining;
    }
    for (std::size_t index = 0; index < lights.size(); ++index) {
        PointLight light = lights[index];
        light.name = "light " + (light.name.empty() ? std::to_string(index) : light.name);
        if (!light.is_on) {
            graph.withhold(light.name, "switched off");
        } else if (!settings.force_all && light.intensity == glm::vec3(0)) {
            graph.withhold(light.name, "its intensity is 0");
        } else {
            shining.push_back(std::move(light));
        }
    }
    return shining;
}

/// The sky's sun, which casts shadows.
PointLight sun_of(const Surroundings& surroundings) {
    PointLight sun;
    sun.name = "sun";
    sun.is_sun = true;
    sun.casts_shadow = true;
    sun.position = glm::vec3(towards_sun(surroundings.sky));
    sun.intensity = glm::vec3(sun_irradiance(surroundings.sky)) * std::exp2(surroundings.exposure);
    return sun;
}

/// The lights of the scene and of its surroundings.
std::vector<PointLight> lights_of(const FrameInputs& inputs, const Surroundings& surroundings) {
    std::vector<PointLight> lights =
        inputs.lights != nullptr ? *inputs.lights : inputs.scene->lights;
    if (surroundings.kind == SurroundingsKind::sky) {
        lights.push_back(sun_of(surroundings));
    }
    return lights;
}

/// What surrounds the scene in this frame; says why nothing does.
Surroundings shown_surroundings(Graph& graph, const FrameInputs& inputs,
                                const FrameSettings& settings) {
    Surroundings out =
        inputs.surroundings != nullptr ? *inputs.surroundings : inputs.scene->surroundings;
    if (out.kind == SurroundingsKind::picture && inputs.surroundings_picture == nullptr) {
        graph.withhold("surroundings levels", "no picture of them is given");
        out.kind = SurroundingsKind::gradient;
    } else if (settings.without.has(Effect::environment)) {
        out.kind = SurroundingsKind::gradient; // switched off
    } else if (!has_map(out.kind)) {
        graph.withhold("surroundings levels", "the gradient and soft boxes need none");
    }
    return out;
}

// What shaders read of lights; those that cast a shadow get their place in the maps.
std::vector<LightBlock> blocks_of(Graph& graph, std::span<const PointLight> lights,
                                  const FrameInputs& inputs, const FrameSettings& settings,
                                  ShadowMaps& shadows) {
    const Geometry& geometry = inputs.gpu_scene->geometry;
    std::vector<LightBlock> out;
    for (const PointLight& light : lights) {
        LightShadow shadow;
        if (!settings.without.has(Effect::shadows)) {
            shadow = shadow_of(*inputs.scene, geometry, light, shadows.size);
            if (shadow.views.empty()) {
                graph.withhold("shadow of " + light.name, shadow.reason);
            }
        }
        const int layer = shadows.add(light, *inputs.scene, geometry, shadow);
        out.push_back(light_block(light, shadow, layer, shadows.size));
    }
    return out;
}

std::vector<std::uint32_t> objects_in_view(Graph& graph, const FrameInputs& inputs,
                                           const FrameSettings& settings, const ViewBlock& view) {
    const Scene& scene = *inputs.scene;
    std::vector<std::uint32_t> out = visible_objects(scene, inputs.gpu_scene->geometry, view.clip);
    if (scene.floor && settings.without.has(Effect::floor)) {
        std::erase(out, *scene.floor);
    } else if (!scene.floor && !settings.without.has(Effect::floor)) {
        graph.withhold("floor", "the scene has its own, or needs none");
    }
    return out;
}

void add_lights(Graph& graph, SceneHandles& handles, std::span<const PointLight> lights,
                std::span<const LightBlock> blocks, bool force_all) {
    if (!blocks.empty()) {
        handles.lights = graph.data("lights", std::as_bytes(blocks));
    }
    handles.light_count = static_cast<std::uint32_t>(lights.size());
    handles.has_spots =
        force_all || std::any_of(lights.begin(), lights.end(),
                                 [](const PointLight& light) { return light.is_spot(); });
    for (const PointLight& light : lights) {
        handles.area_shapes |= area_shape_of(light);
    }
    handles.has_ends =
        force_all || std::any_of(lights.begin(), lights.end(),
                                 [](const PointLight& light) { return light.ends(); });
    handles.has_suns =
        force_all || std::any_of(lights.begin(), lights.end(),
                                 [](const PointLight& light) { return light.is_sun; });
}

SurroundingsHandles declare_surroundings(Graph& graph, const Surroundings& surroundings,
                                         const FrameInputs& inputs, const FrameSettings& settings) {
    if (surroundings.kind == SurroundingsKind::gradient) {
        return {};
    }
    SurroundingsInputs from;
    from.are_kept = settings.reuses_maps();
    from.base = settings.surroundings_base;
    from.exposure = settings.exposure + inputs.scene->exposure;
    if (surroundings.kind == SurroundingsKind::picture) {
        const GpuPicture& picture = *inputs.surroundings_picture;
        from.picture = graph.import("surroundings picture", picture.image, picture.image.desc());
    }
    return add_surroundings(graph, surroundings, from);
}

void tell_textures(Graph& graph, const GpuScene& scene) {
    if (!scene.detail) {
        graph.withhold("textures", "no surface has any");
    } else if (scene.detail->halvings > 0) {
        graph.withhold("the textures' largest " + std::to_string(scene.detail->halvings) +
                           " levels",
                       "the device's buffers have no room for them");
    }
}

} // namespace

DeclaredScene declare_scene(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                            Size size) {
    const Scene& scene = *inputs.scene;
    const GpuScene& gpu_scene = *inputs.gpu_scene;
    const Surroundings surroundings = shown_surroundings(graph, inputs, settings);
    DeclaredScene out;
    const auto no_floor =
        settings.without.has(Effect::floor) ? scene.floor : std::optional<std::uint32_t>{};
    out.takes_light = settings.force_all || scene.takes_light(no_floor);
    std::vector<PointLight> lights;
    if (out.takes_light) {
        lights = shining_lights(graph, lights_of(inputs, surroundings), settings);
    } else if (!settings.without.has(Effect::lights)) {
        graph.withhold("lights", "every surface is unlit: no light changes any");
    }

    out.shadows.are_kept = settings.reuses_maps();
    out.shadows.size = settings.shadow_size > 0 ? settings.shadow_size : scene.shadow_size;
    const std::vector<LightBlock> blocks = blocks_of(graph, lights, inputs, settings, out.shadows);
    const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    const ViewBlock view = view_block(settings.orbit, aspect);
    const Coverings coverings =
        by_covering(scene, gpu_scene.geometry, objects_in_view(graph, inputs, settings, view),
                    glm::vec3(view.position_near));
    out.opaque = draws_of(scene, gpu_scene.geometry, coverings.opaque);
    out.blended = draws_of(scene, gpu_scene.geometry, coverings.blended);

    out.handles = import_scene(graph, scene, gpu_scene, view);
    out.handles.has_own_light |= settings.force_all;
    add_lights(graph, out.handles, lights, blocks, settings.force_all);
    add_environment(graph, out.handles, scene.environment);
    out.surroundings = declare_surroundings(graph, surroundings, inputs, settings);
    tell_textures(graph, gpu_scene);
    return out;
}

} // namespace preview
