// What the camera sees of the geometry, a texel a pixel. A target that the frame does not read gets
// no memory and is not written.
#pragma once

#include "preview/passes/pass.h"
#include "preview/scene/scene_data.h"

namespace preview {

struct [[nodiscard]] GBuffer {
    ImageHandle depth;  ///< d32 or r32f, 0 near to 1 at infinity; 1 where there is nothing
    ImageHandle normal; ///< rg16ui, octahedral, world space
    /// r32ui, 0 where there is nothing: number of the material + 1 and what its normals add to its
    /// roughness (shaders/common/normal_filter.glsl), or in a scene with detail what
    /// shaders/common/surface.glsl says.
    ImageHandle material;
    ImageHandle albedo, emission; ///< rgba16f; only in a scene with detail
};

/// The buffers that surfaces with detail are made from, in the order of their bindings.
void read_detail(Pass& pass, const SceneHandles& scene);

/// With `filters_normals`, surfaces whose normals vary within a pixel are rougher: specular
/// antialiasing. A depth that is kept serves further frames of the same camera.
GBuffer add_gbuffer(Graph& graph, const SceneHandles& scene, Size size, std::vector<Draw> draws,
                    bool filters_normals = false, bool keeps_depth = false);

/// The depth of such surfaces, to be written.
ImageHandle depth_image(Graph& graph, Format format, Size size, bool is_kept);

} // namespace preview
