// The camera: a point that orbits a target, and the matrices that follow from it.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace preview {

/// Angles in degrees, lengths in metres. Azimuth 0 looks along -z and grows to the right of the
/// target; elevation grows upwards.
struct Orbit {
    glm::vec3 target{0};
    float distance = 5;
    float azimuth = 0;
    float elevation = 15;
    float field_of_view = 40; ///< vertical at 16:9 and wider; narrower pictures keep the width
    float near_plane = 0.1F;  ///< the far plane is at infinity
    float roll = 0;           ///< turns the camera about its axis, its top to the left
    glm::vec2 pan{0};         ///< carries target and camera to the camera's right and upwards
};

/// Depth runs from 0 at the near plane to 1 at infinity, y points down in clip space as Vulkan has
/// it.
struct Camera {
    glm::mat4 view{1};
    glm::mat4 projection{1};
    glm::vec3 position{0};
};

/// Elevation is held within +-89 degrees, distance above the near plane, field of view in
/// 0.01..170.
Camera camera_of(const Orbit& orbit, float aspect);

/// The camera where it is, turned to the right and upwards by so many degrees.
Orbit turned_on_the_spot(const Orbit& orbit, float right, float up);

} // namespace preview
