// What the tests of lights and shadows share: a floor under a light, and its radiance.
#pragma once

#include "preview/passes/lighting.h"
#include "preview/passes/shadow.h"
#include "preview/scene/gpu_scene.h"
#include "tests/preview/graph/gpu_test.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace preview {

inline constexpr Size size{96, 64};

inline float float_of_half(std::uint16_t half) {
    const int exponent = half >> 10 & 31;
    const float sign = (half & 0x8000) != 0 ? -1.0F : 1.0F;
    const auto mantissa = static_cast<float>(half & 1023);
    if (exponent == 31) {
        return mantissa > 0 ? std::numeric_limits<float>::quiet_NaN()
                            : sign * std::numeric_limits<float>::infinity();
    }
    return sign *
           (exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(mantissa + 1024, exponent - 25));
}

inline std::vector<float> floats_of(const std::vector<std::uint16_t>& halves) {
    std::vector<float> floats;
    for (const std::uint16_t half : halves) {
        floats.push_back(float_of_half(half));
    }
    return floats;
}

/// A floor of 20 m at y = 0 under one light; the camera looks down at it from the front.
inline Scene floor_scene(const Material& material) {
    Scene scene;
    scene.meshes.push_back(plane());
    scene.materials.push_back(material);
    Object floor;
    floor.transform = glm::scale(glm::mat4(1), glm::vec3(10));
    scene.objects.push_back(floor);
    PointLight light;
    light.position = {0.7F, 2, -0.4F};
    light.intensity = {30, 20, 10};
    light.shadow_angle = 100;
    scene.lights.push_back(light);
    scene.orbit.elevation = 35;
    scene.orbit.distance = 4;
    return scene;
}

class GeometryTest : public GpuTest {
  protected:
    /// Radiance of the scene, four floats a pixel.
    std::vector<float> light(const Scene& scene, std::uint32_t map_size = 512,
                             bool lists_lights = false, std::string_view shadow_filter = "3x3") {
        const GpuScene gpu_scene(device(), scene);
        Graph graph;
        const ViewBlock view = view_block(scene.orbit, 1.5F);
        SceneHandles handles = import_scene(graph, scene, gpu_scene, view);
        add_environment(graph, handles, scene.environment);
        ShadowMaps shadows;
        shadows.size = map_size;
        std::vector<LightBlock> lights;
        for (const PointLight& light : scene.lights) {
            const LightShadow shadow = shadow_of(scene, gpu_scene.geometry, light, shadows.size);
            const int layer = shadows.add(light, scene, gpu_scene.geometry, shadow);
            lights.push_back(light_block(light, shadow, layer, shadows.size));
        }
        handles.has_suns = std::any_of(scene.lights.begin(), scene.lights.end(),
                                       [](const PointLight& light) { return light.is_sun; });
        if (!lights.empty()) {
            handles.lights = graph.data("lights", std::as_bytes(std::span(lights)));
        }
        handles.light_count = static_cast<std::uint32_t>(lights.size());
        handles.has_spots = std::any_of(scene.lights.begin(), scene.lights.end(),
                                        [](const PointLight& light) { return light.is_spot(); });
        handles.has_ends = std::any_of(scene.lights.begin(), scene.lights.end(),
                                       [](const PointLight& light) { return light.ends(); });
        for (const PointLight& light : scene.lights) {
            handles.area_shapes |= area_shape_of(light);
        }
        LightingInputs inputs;
        inputs.shadow_maps = add_shadows(graph, handles, std::move(shadows));
        inputs.surfaces =
            add_gbuffer(graph, handles, size,
                        draws_of(scene, gpu_scene.geometry,
                                 visible_objects(scene, gpu_scene.geometry, view.clip)));
        inputs.environment = !scene.environment.is_black();
        inputs.lists_lights = lists_lights;
        inputs.shadow_filter = shadow_filter_named(shadow_filter);
        const ImageHandle lit = add_lighting(graph, handles, inputs);
        graph.present(lit);
        return floats_of(run_and_read<std::uint16_t>(graph, lit));
    }
};

/// Where the ray of a pixel's centre meets the floor; above the horizon, nothing sensible.
inline glm::dvec3 on_floor(const ViewBlock& view, std::uint32_t x, std::uint32_t y,
                           glm::dvec3& ray) {
    const double sx = (x + 0.5) / size.width * 2 - 1;
    const double sy = (y + 0.5) / size.height * 2 - 1;
    ray = glm::dvec3(view.forward) + sx * glm::dvec3(view.right) + sy * glm::dvec3(view.up);
    const glm::dvec3 eye(view.position_near);
    return eye - ray * (eye.y / ray.y);
}

} // namespace preview
