// Deferred lighting: GGX and Lambert under every point light with its shadow, the surroundings,
// emission, and the background where there is no surface.
#pragma once

#include "preview/finish/light_filters.h"
#include "preview/passes/gbuffer.h"
#include "preview/passes/surroundings.h"

namespace preview {

struct LightingInputs {
    GBuffer surfaces;
    ImageHandle shadow_maps; ///< empty: no light casts
    const ShadowFilter* shadow_filter = shadow_filter_named("3x3");
    ImageHandle occlusion; ///< of the surroundings; empty: there is none
    bool environment = true;
    bool lists_lights = false; ///< each tile evaluates those alone that can reach its surfaces
    bool takes_light = true;   ///< some surface of the scene does; else they only give their own
    /// In place of radiance how many lights each pixel evaluates.
    bool counts_lights = false;
    SurroundingsHandles surroundings; ///< of the gradient: nothing but the scene's environment
};

/// Whether lists of lights are worth their making, and possible: there are many, with cones or a
/// reach.
bool may_list_lights(const SceneHandles& scene);

/// Of every shader that includes shaders/common/lit_surface.glsl; `own` follow.
std::vector<std::uint32_t> lighting_constants(const SceneHandles& scene,
                                              const LightingInputs& inputs,
                                              std::initializer_list<std::uint32_t> own);

/// The six bindings of shaders/common/surroundings.glsl.
void read_surroundings(Pass& pass, const SurroundingsHandles& surroundings);

/// Radiance, rgba16f. May hold anything that the inputs make of it; the HDR resolve comes next.
ImageHandle add_lighting(Graph& graph, const SceneHandles& scene, const LightingInputs& inputs);

} // namespace preview
