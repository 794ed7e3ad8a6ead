// Ambient occlusion from the g-buffer: the share of the surroundings that nearby surfaces hide.
//
// N points about each pixel, in cosine-weighted directions about the normal, at distances
// radius u^2 with u even in 0..1. A point counts as hidden when it lies behind the surface that the
// picture shows there, by no more than twice the radius, and that surface stands out of the pixel's
// tangent plane. So a hit at distance d weighs 1 - sqrt(d / radius). This is done for the first
// pixel of a cell, of two by two pixels where nobody asks for others. Offsets repeat every 4x4
// cells, and two blurs over a period, which stop where the surface leaves the tangent plane,
// average 16 N points; pixels between take those beside that lie in their plane, by how near they
// are. Known bounds: what no pixel shows hides nothing.
#pragma once

#include "preview/passes/gbuffer.h"

namespace preview {

struct OcclusionInputs {
    float strength = 1; ///< 0..2; times what is hidden
    float radius = 0.3F;
    std::uint32_t samples = 16;
    std::uint32_t cell = 2; ///< side of a cell, in pixels
};

/// What is left of the light from the surroundings, r32f, 0..1; 1 where there is no surface.
ImageHandle add_occlusion(Graph& graph, const SceneHandles& scene, const GBuffer& surfaces,
                          const OcclusionInputs& inputs);

} // namespace preview
