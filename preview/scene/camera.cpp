#include "preview/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace preview {

namespace {

/// Unit, from the target to the camera.
glm::vec3 away_of(const Orbit& orbit) {
    const float elevation = glm::radians(std::clamp(orbit.elevation, -89.0F, 89.0F));
    const float azimuth = glm::radians(orbit.azimuth);
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
            std::cos(elevation) * std::cos(azimuth)};
}

float distance_of(const Orbit& orbit) {
    return std::max(orbit.distance, orbit.near_plane * 1.01F);
}

} // namespace

Camera camera_of(const Orbit& orbit, float aspect) {
    const glm::vec3 away = away_of(orbit);
    const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), away));
    const glm::vec3 target =
        orbit.target + orbit.pan.x * right + orbit.pan.y * glm::cross(away, right);
    Camera camera;
    camera.position = target + distance_of(orbit) * away;
    camera.view = glm::lookAt(camera.position, target, glm::vec3{0, 1, 0});
    if (orbit.roll != 0) {
        camera.view =
            glm::rotate(glm::mat4(1), glm::radians(-orbit.roll), glm::vec3{0, 0, 1}) * camera.view;
    }

    constexpr float framed_aspect = 16.0F / 9;
    const float half = glm::radians(std::clamp(orbit.field_of_view, 0.01F, 170.0F)) / 2;
    const float focal = std::min(1.0F, aspect / framed_aspect) / std::tan(half);
    camera.projection = glm::mat4{0};
    camera.projection[0][0] = focal / aspect;
    camera.projection[1][1] = -focal;
    camera.projection[2][2] = -1;
    camera.projection[2][3] = -1;
    camera.projection[3][2] = -orbit.near_plane;
    return camera;
}

Orbit turned_on_the_spot(const Orbit& orbit, float right, float up) {
    Orbit out = orbit;
    out.azimuth = std::remainder(orbit.azimuth - right, 360.0F);
    out.elevation = std::clamp(orbit.elevation - up, -89.0F, 89.0F);
    out.pan = glm::vec2(0);
    out.target = camera_of(orbit, 1).position - distance_of(orbit) * away_of(out);
    return out;
}

} // namespace preview
