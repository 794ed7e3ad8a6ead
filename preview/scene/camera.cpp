#include "preview/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace preview {

Camera camera_of(const Orbit& orbit, float aspect) {
    const float elevation = glm::radians(std::clamp(orbit.elevation, -89.0f, 89.0f));
    const float azimuth = glm::radians(orbit.azimuth);
    const float distance = std::max(orbit.distance, orbit.near_plane * 1.01f);
    const glm::vec3 away{std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                         std::cos(elevation) * std::cos(azimuth)};
    Camera camera;
    camera.position = orbit.target + distance * away;
    camera.view = glm::lookAt(camera.position, orbit.target, glm::vec3{0, 1, 0});
    if (orbit.roll != 0) {
        camera.view =
            glm::rotate(glm::mat4(1), glm::radians(-orbit.roll), glm::vec3{0, 0, 1}) * camera.view;
    }

    constexpr float framed_aspect = 16.0f / 9;
    const float half = glm::radians(std::clamp(orbit.field_of_view, 0.01f, 170.0f)) / 2;
    const float focal = std::min(1.0f, aspect / framed_aspect) / std::tan(half);
    camera.projection = glm::mat4{0};
    camera.projection[0][0] = focal / aspect;
    camera.projection[1][1] = -focal;
    camera.projection[2][2] = -1;
    camera.projection[2][3] = -1;
    camera.projection[3][2] = -orbit.near_plane;
    return camera;
}

} // namespace preview
