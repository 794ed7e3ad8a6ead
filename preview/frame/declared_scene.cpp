#include "preview/frame/declared_scene.h"

#include "preview/scene/gpu_scene.h"

#include <algorithm>
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

} // namespace

DeclaredScene declare_scene(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                            Size size) {
    DeclaredScene out;
    out.shadows.size = settings.shadow_size;
    out.shadows.are_kept = !settings.force_all;
    const Scene& scene = *inputs.scene;
    const GpuScene& gpu_scene = *inputs.gpu_scene;
    const Geometry& geometry = gpu_scene.geometry;
    const std::vector<PointLight> lights =
        shining_lights(graph, inputs.lights != nullptr ? *inputs.lights : scene.lights, settings);
    std::vector<int> layers;
    for (std::uint32_t index = 0; index < lights.size(); ++index) {
        if (settings.without.has(Effect::shadows)) {
            layers.push_back(-1);
            continue;
        }
        const ShadowCasters casters = shadow_casters(scene, geometry, lights[index]);
        if (casters.objects.empty()) {
            graph.withhold("shadow of " + lights[index].name, casters.reason);
            layers.push_back(-1);
        } else {
            layers.push_back(static_cast<int>(out.shadows.maps.size()));
            out.shadows.add(lights[index], scene, geometry, casters.objects);
        }
    }
    const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    const ViewBlock view = view_block(settings.orbit, aspect);
    out.visible = draws_of(scene, geometry, visible_objects(scene, geometry, view.clip));

    out.handles = import_scene(graph, scene, gpu_scene, view);
    SceneHandles& handles = out.handles;
    const auto blocks = light_blocks(lights, layers, settings.shadow_size);
    if (!blocks.empty()) {
        handles.lights = graph.data("lights", std::as_bytes(std::span(blocks)));
    }
    handles.environment = graph.data_of("environment", environment_block(scene.environment));
    handles.light_count = static_cast<std::uint32_t>(lights.size());
    handles.has_spots =
        settings.force_all || std::any_of(lights.begin(), lights.end(),
                                          [](const PointLight& light) { return light.is_spot(); });
    if (!gpu_scene.detail) {
        graph.withhold("textures", "no surface has any");
    } else if (gpu_scene.detail->halvings > 0) {
        graph.withhold("the textures' largest " + std::to_string(gpu_scene.detail->halvings) +
                           " levels",
                       "the device's buffers have no room for them");
    }
    return out;
}

} // namespace preview
