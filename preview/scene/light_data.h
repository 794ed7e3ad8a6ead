// Lights in the form that the shaders read, and the views of their shadow maps. Plain data.
#pragma once

#include "preview/scene/scene_data.h"

#include <string>
#include <string_view>
#include <vector>

namespace preview {

/// What a shadow map sees: from the light's position along `forward`, square. A sun's sees a box
/// about the casters from `origin`, the middle of its near side.
struct ShadowFrustum {
    glm::vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, 1}; ///< unit, across each other
    float tangent = 1; ///< of half its angle; a sun's: half the box's side
    float near_plane = 0.1F, far_plane = 20;
    bool is_parallel = false;
    glm::vec3 origin{0};
};

/// World to clip space of a shadow map; depth runs from 0 to 1.
glm::mat4 shadow_clip(const PointLight& light, const ShadowFrustum& frustum);

/// One map of a light.
struct ShadowView {
    ShadowFrustum frustum;
    std::string_view side;              ///< of six: "+x"; else empty
    std::vector<std::uint32_t> casters; ///< that it shows
};

/// The maps of a light, or why there are none.
struct LightShadow {
    std::vector<ShadowView> views; ///< one, or six all round: +x, -x, +y, ...
    std::uint32_t faces = 0;       ///< of six those that show casters, by bits
    std::string reason;            ///< empty when `views` is not
};

/// A light has no maps where they would show no caster, or where there is no receiver: an object
/// that light changes. All round there are six or none, so that a light may move among objects
/// without a change of the frame's passes. `map_size` is the side of each in texels.
LightShadow shadow_of(const Scene& scene, const Geometry& geometry, const PointLight& light,
                      std::uint32_t map_size);

/// Of SceneHandles::area_shapes; none for a point.
inline std::uint32_t area_shape_of(const PointLight& light) {
    return light.is_point() ? 0 : 1U << static_cast<unsigned>(light.lit_shape());
}

/// The light's block. `first_layer` is that of its shadow's first view, -1 where it has none.
LightBlock light_block(const PointLight& light, const LightShadow& shadow, int first_layer,
                       std::uint32_t map_size);

} // namespace preview
