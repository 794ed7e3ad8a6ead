// How near to the camera what it sees may be.
#pragma once

#include "preview/scene/scene_data.h"

namespace preview {

/// A lower bound of the view depth of every surface in the picture, in metres: of the part of each
/// object's box that the frustum of `clip` has. At least near_plane; infinite where there is
/// nothing.
float nearest_depth(const Scene& scene, const Geometry& geometry, const glm::mat4& clip,
                    float near_plane);

} // namespace preview
