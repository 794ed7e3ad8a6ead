// What the camera sees of the geometry, a texel a pixel. A target that the frame does not read gets
// no memory and is not written.
#pragma once

#include "preview/passes/scene_data.h"

namespace preview {

struct GBuffer {
    Handle depth;    ///< d32, 0 near to 1 at infinity; 1 where there is nothing
    Handle normal;   ///< rg16ui, octahedral, world space
    Handle albedo;   ///< rgba16
    Handle material; ///< rgba8: roughness, metalness
    Handle emission; ///< rgba16f
};

GBuffer add_gbuffer(Graph& graph, const SceneHandles& scene, Size size, std::vector<Draw> draws);

} // namespace preview
