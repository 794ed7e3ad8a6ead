// Surfaces that are lit as they are drawn: what is see-through, over the picture of the others; or,
// in place of the deferred way, all of them.
#pragma once

#include "preview/passes/lighting.h"

namespace preview {

/// Draws `draws`, which go over `lit` in their order, hidden by inputs.surfaces.depth. No ambient
/// occlusion darkens them. Returns the new version of `lit`.
ImageHandle add_blended(Graph& graph, const SceneHandles& scene, const LightingInputs& inputs,
                        ImageHandle lit, std::vector<Draw> draws, bool filters_normals = false);

struct [[nodiscard]] ForwardPicture {
    ImageHandle lit;   ///< radiance, rgba16f
    ImageHandle depth; ///< d32, as of a GBuffer
};

/// Draws `draws` before the background. As add_gbuffer() and add_lighting(), the rounding of a
/// g-buffer apart; without ambient occlusion. inputs.surfaces is not read.
ForwardPicture add_forward(Graph& graph, const SceneHandles& scene, const LightingInputs& inputs,
                           Size size, std::vector<Draw> draws, bool filters_normals = false,
                           bool keeps_depth = false);

} // namespace preview
