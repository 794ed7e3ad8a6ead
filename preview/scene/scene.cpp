#include "preview/scene/scene.h"

#include "lutlib/named.h"
#include "preview/scene/builtin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace preview {

bool Scene::has_casting_light() const {
    return std::any_of(lights.begin(), lights.end(), [](const PointLight& light) {
        return light.casts_shadow && light.intensity != glm::vec3{0};
    });
}

bool Scene::has_detail() const {
    return std::any_of(meshes.begin(), meshes.end(),
                       [](const Mesh& mesh) { return !mesh.details.empty(); }) ||
           std::any_of(materials.begin(), materials.end(), [](const Material& material) {
               return !(material.detail == MaterialDetail{});
           });
}

bool Scene::has_emitter() const {
    return std::any_of(objects.begin(), objects.end(), [&](const Object& object) {
        return materials[object.material].emission != glm::vec3{0};
    });
}

bool Scene::has_own_light() const {
    return std::any_of(objects.begin(), objects.end(), [&](const Object& object) {
        const Material& material = materials[object.material];
        return material.detail.is_unlit || material.emission != glm::vec3{0};
    });
}

bool Scene::takes_light(std::optional<std::uint32_t> without) const {
    for (std::uint32_t index = 0; index < objects.size(); ++index) {
        if (index != without && !materials[objects[index].material].detail.is_unlit) {
            return true;
        }
    }
    return false;
}

Bounds Scene::bounds() const {
    Bounds all;
    for (const Object& object : objects) {
        all.include(bounds_of(meshes[object.mesh]), object.transform);
    }
    return all;
}

glm::vec3 PointLight::towards_sun() const {
    const glm::vec3 towards = position - aim;
    const float length = glm::length(towards);
    return length > 0 ? towards / length : glm::vec3{0, 1, 0};
}

std::span<const SceneInfo> scenes() {
    static constexpr std::array<SceneInfo, 7> table{{
        {"sample", "still life by a window: wood, linen, metal, fruit, leaves, skin, true blacks",
         sample_scene, animate_sample},
        {"studio", "photographer's cove with chart, ramps, metals, neon and a very bright spark",
         studio_scene, animate_studio},
        {"plain", "the studio's shapes under plain light: no shadow, no emitter", plain_scene,
         animate_studio},
        {"night", "wet street: lamp, shop window, neon of nearly one primary, deep shadow",
         night_scene},
        {"exterior", "terrace above hills under a clear sky; --sun-height moves its sun",
         exterior_scene},
        {"materials", "roughness, metalness, measured metals and surfaces with textures",
         materials_scene},
        {.name = "chart",
         .help = "light of exactly known values: ColorChecker, stops, hues, ramps, skins",
         .make = chart_scene,
         .tonemap = "none",
         .bloom = "none",
         .is_antialiased = false},
    }};
    return table;
}

const SceneInfo* scene_named(std::string_view name) {
    return lutlib::find_named(scenes(), name);
}

Scene scene_at(const SceneInfo& info, double seconds) {
    Scene scene = info.make();
    if (info.animate) {
        info.animate(scene, seconds);
    }
    return scene;
}

} // namespace preview
