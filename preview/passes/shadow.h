// Shadow maps: one layer of a depth array for each light that casts, seen from the light.
#pragma once

#include "preview/scene/scene_data.h"

namespace preview {

/// What one light's map shows.
struct ShadowMap {
    std::string name;        ///< of the light, for people
    std::uint32_t light = 0; ///< its number
    std::vector<Draw> draws;
};

/// The array of all maps, each `size` texels square, in their order; empty where there are none.
ImageHandle add_shadows(Graph& graph, const SceneHandles& scene, std::uint32_t size,
                        std::vector<ShadowMap> maps);

} // namespace preview
