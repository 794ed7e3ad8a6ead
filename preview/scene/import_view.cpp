#include "preview/scene/import_parts.h"

#include "preview/scene/builtin.h"

#include <assimp/camera.h>
#include <assimp/light.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace preview {

namespace {

bool is_finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

struct Ball {
    glm::vec3 centre{0};
    float radius = 1;
};

Ball ball_about(const Scene& scene) {
    const Bounds box = scene.bounds();
    return {(box.min + box.max) / 2.0F, std::max(glm::length(box.max - box.min) / 2, 1e-3F)};
}

/// All of the ball, from the front, a little above and aside.
Orbit framing(const Ball& ball) {
    Orbit orbit;
    orbit.target = ball.centre;
    orbit.field_of_view = 27;
    orbit.azimuth = 25;
    orbit.elevation = 15;
    orbit.distance = ball.radius / std::sin(glm::radians(orbit.field_of_view / 2));
    return orbit;
}

/// A camera at `place`, which looks along its -z, as glTF has it; Assimp 5.2 adds the node's
/// translation once more. Its target lies as far away as the ball.
Orbit orbit_of(const glm::mat4& place, float vertical_field, const Ball& ball, LeftOut& left_out) {
    const glm::vec3 position(place[3]);
    const glm::vec3 forward = -glm::normalize(glm::vec3(place[2]));
    const glm::vec3 up = glm::normalize(glm::vec3(place[1]));
    Orbit orbit;
    orbit.distance = std::max(glm::dot(ball.centre - position, forward), 2 * orbit.near_plane);
    orbit.target = position + orbit.distance * forward;
    orbit.elevation = glm::degrees(std::asin(std::clamp(-forward.y, -1.0F, 1.0F)));
    orbit.azimuth = glm::degrees(std::atan2(-forward.x, -forward.z));
    orbit.field_of_view = glm::degrees(vertical_field);
    const glm::vec3 level = glm::cross(forward, glm::vec3(0, 1, 0));
    constexpr float least_roll = 0.02F; // about a degree
    if (std::abs(glm::dot(up, level)) > least_roll) {
        left_out.add("roll of the camera");
    }
    return orbit;
}

void import_camera(const aiScene& file, const GltfFacts& facts, const Places& nodes,
                   const glm::mat4& fit, const Ball& ball, Scene& scene, LeftOut& left_out) {
    scene.orbit = framing(ball);
    bool has_camera = false;
    for (unsigned i = 0; i < file.mNumCameras; ++i) {
        const aiCamera& camera = *file.mCameras[i];
        const auto node = nodes.find(camera.mName.C_Str());
        const float field = i < facts.vertical_fields.size() ? facts.vertical_fields[i] : 0;
        if (node == nodes.end() || has_camera || !(field > 0)) {
            left_out.add("cameras (the first perspective one is taken)");
            continue;
        }
        const Orbit orbit = orbit_of(fit * node->second, field, ball, left_out);
        has_camera = is_finite(orbit.target) && std::isfinite(orbit.field_of_view);
        if (has_camera) {
            scene.orbit = orbit;
        }
    }
}

/// Its shadow map sees the ball from outside of it, and a wide half of it from inside.
void aim_shadow(PointLight& light, const Ball& ball) {
    const float distance = glm::length(ball.centre - light.position);
    light.casts_shadow = true;
    light.aim = ball.centre;
    light.shadow_angle = 120;
    if (distance > ball.radius) {
        light.shadow_angle =
            std::min(glm::degrees(2 * std::asin(ball.radius / distance)) + 1, 120.0F);
    }
    light.shadow_near = std::max(distance - ball.radius, 0.02F * ball.radius) * 0.99F;
    light.shadow_far = (distance + ball.radius) * 1.01F;
}

/// Lights shine in candela and lux, taken as radiance times m^2 and radiance.
PointLight import_light(const aiLight& given, const glm::mat4& place, const Ball& ball, float scale,
                        LeftOut& left_out) {
    constexpr float sun_distance = 100; // in radii: its rays are parallel to half a degree
    PointLight light;
    light.name = given.mName.C_Str();
    light.intensity = {given.mColorDiffuse.r, given.mColorDiffuse.g, given.mColorDiffuse.b};
    if (given.mType == aiLightSource_DIRECTIONAL) {
        const glm::vec3 along = -glm::normalize(glm::vec3(place[2]));
        const float distance = sun_distance * ball.radius;
        light.position = ball.centre - distance * along;
        light.intensity *= distance * distance;
    } else {
        light.position = glm::vec3(place[3]);
        light.intensity *= scale * scale;
        if (given.mType == aiLightSource_SPOT) {
            left_out.add("cones of spot lights (they shine in all directions)");
        }
    }
    aim_shadow(light, ball);
    return light;
}

void dim(Environment& environment, float factor) {
    for (glm::vec3* radiance : {&environment.zenith, &environment.horizon, &environment.ground}) {
        *radiance *= factor;
    }
    for (SoftBox& box : environment.soft_boxes) {
        box.radiance *= factor;
    }
}

void import_lights(const aiScene& file, const Places& nodes, const glm::mat4& fit, const Ball& ball,
                   Scene& scene, LeftOut& left_out) {
    const float scale = glm::length(glm::vec3(fit[0]));
    for (unsigned i = 0; i < file.mNumLights; ++i) {
        const auto node = nodes.find(file.mLights[i]->mName.C_Str());
        if (node == nodes.end() || scene.lights.size() == import_limits.lights) {
            left_out.add("lights beyond the first " + std::to_string(import_limits.lights));
            continue;
        }
        PointLight light =
            import_light(*file.mLights[i], fit * node->second, ball, scale, left_out);
        if (is_finite(light.position) && is_finite(light.intensity)) {
            scene.lights.push_back(std::move(light));
        } else {
            left_out.add("lights with numbers that are not finite");
        }
    }
    const Scene sample = sample_scene();
    scene.environment = sample.environment;
    if (scene.lights.empty()) {
        scene.lights = {sample.lights.front()};
        aim_shadow(scene.lights.front(), ball);
        return;
    }
    float irradiance = 0; // of a sheet in the middle that faces every light
    for (const PointLight& light : scene.lights) {
        const glm::vec3 away = light.position - ball.centre;
        const float nearest = 0.25F * ball.radius;
        irradiance += std::max({light.intensity.x, light.intensity.y, light.intensity.z}) /
                      std::max(glm::dot(away, away), nearest * nearest);
    }
    if (irradiance > 0) {
        scene.exposure =
            std::clamp(std::log2(std::numbers::pi_v<float> / irradiance), -20.0F, 20.0F);
    }
    dim(scene.environment, std::exp2(-scene.exposure)); // exposed, they look as the sample's do
}

} // namespace

void import_view(const aiScene& file, const GltfFacts& facts, const Places& nodes,
                 const glm::mat4& fit, Scene& scene, LeftOut& left_out) {
    const Ball ball = ball_about(scene);
    import_camera(file, facts, nodes, fit, ball, scene, left_out);
    import_lights(file, nodes, fit, ball, scene, left_out);
}

} // namespace preview
