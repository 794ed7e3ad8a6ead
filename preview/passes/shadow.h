// Shadow maps: layers of a depth array for each light that casts, seen from the light: one, or up
// to six around it.
#pragma once

#include "preview/scene/light_data.h"

#include <string>
#include <vector>

namespace preview {

/// What one light's map shows.
struct ShadowMap {
    std::string name;        ///< of the light, for people
    glm::mat4 clip{1};       ///< world to the light's clip space
    std::vector<Draw> draws; ///< the instance is the caster's number
};

/// What all maps show, and nothing else: the maps are right as long as this stays.
struct ShadowMaps {
    std::uint32_t size = 1024; ///< of the side of each, in texels
    bool are_kept = true;      ///< from frame to frame; else drawn in each
    std::vector<ShadowMap> maps;
    std::vector<CasterBlock> casters;     ///< of the scene; as many whatever a light sees of them
    std::vector<std::uint32_t> materials; ///< of the casters

    /// The maps of a light. Returns the layer of the first, -1 where there is none.
    int add(const PointLight& light, const Scene& scene, const Geometry& geometry,
            const LightShadow& shadow);
};

/// The array of all maps in their order; empty where there are none.
ImageHandle add_shadows(Graph& graph, const SceneHandles& scene, ShadowMaps shadows);

} // namespace preview
