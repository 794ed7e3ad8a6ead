#include "lutlib/error.h"
#include "preview/scene/builtin.h"
#include "preview/scene/import_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
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

/// In double: what stands far from the file's origin is brought near to ours.
glm::mat4 carried(const glm::dmat4& fit, const glm::mat4& place) {
    return glm::mat4(fit * glm::dmat4(place));
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

/// The camera's view of the file, carried by `fit`, with its target as far away as the ball. An
/// orthographic one stands so far away that its rays are parallel to a quarter of a degree.
Orbit orbit_of(const FileCamera& camera, const glm::dmat4& fit, const Ball& ball) {
    constexpr float far_away = 200; // in radii
    const glm::mat4 place = carried(fit, camera.place);
    const glm::vec3 forward = -glm::normalize(glm::vec3(place[2]));
    const glm::vec3 up = glm::normalize(glm::vec3(place[1]));
    glm::vec3 position(place[3]);
    Orbit orbit;
    orbit.distance = std::max(glm::dot(ball.centre - position, forward), 2 * orbit.near_plane);
    orbit.target = position + orbit.distance * forward;
    orbit.field_of_view = glm::degrees(camera.vertical_field);
    if (camera.vertical_field == 0) {
        const float scale = static_cast<float>(glm::length(glm::dvec3(fit[0])));
        orbit.distance = far_away * ball.radius;
        orbit.near_plane = orbit.distance / 2;
        orbit.field_of_view =
            glm::degrees(2 * std::atan(std::abs(camera.half_height) * scale / orbit.distance));
    }
    orbit.elevation = glm::degrees(std::asin(std::clamp(-forward.y, -1.0F, 1.0F)));
    orbit.azimuth = glm::degrees(std::atan2(-forward.x, -forward.z));
    const glm::vec3 across = glm::cross(forward, glm::vec3(0, 1, 0));
    if (const float length = glm::length(across); length > 1e-4F) {
        const glm::vec3 right = across / length;
        orbit.roll = glm::degrees(
            std::atan2(-glm::dot(up, right), glm::dot(up, glm::cross(right, forward))));
    } else { // straight down or up: what is above in the picture tells the direction
        const glm::vec3 back = forward.y < 0 ? -up : up;
        orbit.azimuth = glm::degrees(std::atan2(back.x, back.z));
    }
    return orbit;
}

void import_cameras(const std::vector<FileCamera>& cameras, const glm::dmat4& fit, const Ball& ball,
                    Scene& scene, LeftOut& left_out) {
    scene.orbit = framing(ball);
    for (const FileCamera& camera : cameras) {
        const Orbit orbit = orbit_of(camera, fit, ball);
        if (is_finite(orbit.target) && std::isfinite(orbit.field_of_view) &&
            std::isfinite(orbit.azimuth + orbit.elevation + orbit.roll + orbit.distance)) {
            scene.cameras.push_back({camera.name, orbit});
        } else {
            left_out.add("cameras with numbers that are not finite");
        }
    }
    if (!scene.cameras.empty()) {
        scene.orbit = scene.cameras.front().orbit;
    }
}

/// Its shadow map sees the ball from outside of it, and a wide half of it from inside.
void aim_shadow(PointLight& light, const Ball& ball) {
    const float distance = glm::length(ball.centre - light.position);
    light.casts_shadow = true;
    light.aim = ball.centre;
    light.shadow_angle = PointLight::all_round;
    if (distance > ball.radius) {
        const float angle = glm::degrees(2 * std::asin(ball.radius / distance)) + 1;
        light.shadow_angle = angle < 120 ? angle : PointLight::all_round;
    }
    light.shadow_near = std::max(distance - ball.radius, 0.02F * ball.radius) * 0.99F;
    light.shadow_far = (distance + ball.radius) * 1.01F;
}

PointLight light_of(const FileLight& given, const glm::dmat4& fit, const Ball& ball) {
    const glm::mat4 place = carried(fit, given.place);
    const glm::vec3 along = -glm::normalize(glm::vec3(place[2]));
    PointLight light;
    light.name = given.name;
    light.intensity = given.intensity;
    if (given.kind == FileLight::Kind::sun) {
        light.is_sun = true;
        light.position = ball.centre - 2 * ball.radius * along;
    } else {
        const float scale = static_cast<float>(glm::length(glm::dvec3(fit[0])));
        light.position = glm::vec3(place[3]);
        light.intensity *= scale * scale;
        light.reach = scale * given.range;
    }
    aim_shadow(light, ball);
    if (given.kind == FileLight::Kind::spot) {
        light.axis = along;
        light.inner_angle = glm::degrees(given.inner_angle);
        light.outer_angle = glm::degrees(given.outer_angle);
        light.aim = light.position + along;
        light.shadow_angle = std::clamp(2 * light.outer_angle + 1, 1.0F, 170.0F);
    }
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

void import_lights(const std::vector<FileLight>& lights, const glm::dmat4& fit, const Ball& ball,
                   Scene& scene, LeftOut& left_out) {
    for (const FileLight& given : lights) {
        PointLight light = light_of(given, fit, ball);
        if (is_finite(light.position) && is_finite(light.intensity) && is_finite(light.axis) &&
            is_finite(light.aim)) {
            scene.lights.push_back(std::move(light));
        } else {
            left_out.add("lights with numbers that are not finite");
        }
    }
    const Scene studio = studio_scene();
    scene.environment = studio.environment;
    if (scene.lights.empty()) {
        scene.lights = {studio.lights.front()};
        aim_shadow(scene.lights.front(), ball);
        return;
    }
    float irradiance = 0; // of a sheet in the middle that faces every light
    for (const PointLight& light : scene.lights) {
        const glm::vec3 away = light.position - ball.centre;
        const float nearest = 0.25F * ball.radius;
        const float squared =
            light.is_sun ? 1.0F : std::max(glm::dot(away, away), nearest * nearest);
        irradiance += std::max({light.intensity.x, light.intensity.y, light.intensity.z}) / squared;
    }
    if (irradiance > 0) {
        scene.exposure =
            std::clamp(std::log2(std::numbers::pi_v<float> / irradiance), -20.0F, 20.0F);
    }
    dim(scene.environment, std::exp2(-scene.exposure)); // exposed, they look as the studio's do
}

/// Carries the file's world to where the built-in scene stands.
glm::dmat4 fit_of(const Scene& scene, const std::string& path, const LeftOut& left_out) {
    constexpr glm::vec3 fit_centre{0.26F, 0.62F, -0.1F}; // where the studio's camera looks
    constexpr float fit_radius = 1.5F;
    constexpr float most_radius = 1e9F;
    const Bounds box = scene.bounds();
    const glm::vec3 size = box.max - box.min;
    const float radius = glm::length(size) / 2;
    if (box.empty() || !(radius > 0) || !(radius < most_radius)) {
        std::string message = "it holds no triangles to show";
        for (const std::string& line : left_out.lines()) {
            message += "; left out: " + line;
        }
        throw lutlib::Error(message, {path, 0, {}});
    }
    const double scale = static_cast<double>(fit_radius) / static_cast<double>(radius);
    glm::dmat4 fit(scale);
    fit[3] = glm::dvec4(glm::dvec3(fit_centre) - scale * glm::dvec3(box.min + size / 2.0F), 1);
    return fit;
}

/// Moves a mesh that stands far from its origin there, where floats are finer; returns whence.
glm::dvec3 centred(Mesh& mesh) {
    constexpr float far_away = 1000; // in radii
    const Bounds box = bounds_of(mesh);
    const glm::vec3 centre = box.min + (box.max - box.min) / 2.0F;
    if (box.empty() || !(glm::length(centre) > far_away * glm::length(box.max - box.min) / 2)) {
        return glm::dvec3(0);
    }
    for (Vertex& vertex : mesh.vertices) {
        vertex.position -= centre;
    }
    return glm::dvec3(centre);
}

void carry_objects(const glm::dmat4& fit, Scene& scene) {
    std::vector<glm::dvec3> centres;
    for (Mesh& mesh : scene.meshes) {
        centres.push_back(centred(mesh));
    }
    for (Object& object : scene.objects) {
        const glm::dmat4 place(object.transform);
        object.transform =
            glm::mat4(fit * place * glm::translate(glm::dmat4(1), centres[object.mesh]));
    }
}

} // namespace

Scene settled(FileScene file, const std::string& path, LeftOut& left_out) {
    Scene scene = std::move(file.scene);
    const glm::dmat4 fit = fit_of(scene, path, left_out);
    carry_objects(fit, scene);
    const Ball ball = ball_about(scene);
    import_cameras(file.cameras, fit, ball, scene, left_out);
    import_lights(file.lights, fit, ball, scene, left_out);
    scene.occlusion = 1;
    return scene;
}

} // namespace preview
