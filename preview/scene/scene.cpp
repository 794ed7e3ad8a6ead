#include "preview/scene/scene.h"

#include "lutlib/named.h"
#include "preview/scene/builtin.h"
#include "preview/scene/swatches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec4.hpp>

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

Bounds Scene::bounds() const {
    Bounds all;
    for (const Object& object : objects) {
        const Bounds box = bounds_of(meshes[object.mesh]);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec4 p{corner & 1 ? box.max.x : box.min.x,
                              corner & 2 ? box.max.y : box.min.y,
                              corner & 4 ? box.max.z : box.min.z, 1};
            all.include(glm::vec3{object.transform * p});
        }
    }
    return all;
}

glm::vec3 linear_of(const Swatch& swatch) {
    glm::vec3 linear;
    for (int channel = 0; channel < 3; ++channel) {
        const double v = swatch.srgb[static_cast<std::size_t>(channel)] / 255.0;
        linear[channel] =
            static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
    return linear;
}

glm::vec3 linear_of(std::uint32_t srgb) {
    const auto code = [&](int shift) { return static_cast<std::uint8_t>(srgb >> shift & 255u); };
    return linear_of(Swatch{"", {code(16), code(8), code(0)}});
}

std::span<const SceneInfo> scenes() {
    static constexpr std::array<SceneInfo, 4> table{{
        {"sample", "still life with chart, ramps, metals, neon and a small very bright source",
         sample_scene, animate_sample},
        {"plain", "the same shapes under plain light: no shadow, no emitter", plain_scene,
         animate_sample},
        {"materials", "spheres over roughness and metalness", materials_scene, nullptr},
        {"chart", "patches that emit exactly their published values", chart_scene, nullptr},
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
