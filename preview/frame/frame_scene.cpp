#include "preview/frame/frame_scene.h"

#include "preview/effects/effect.h"
#include "preview/frame/declared_scene.h"
#include "preview/frame/frame.h"
#include "preview/passes/forward.h"
#include "preview/passes/geometry_view.h"
#include "preview/passes/lighting.h"
#include "preview/passes/occlusion.h"
#include "preview/passes/shadow.h"
#include "preview/passes/visibility.h"
#include "preview/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace preview {

namespace {

/// Whether effects in use will ask for the depth of a scene that is then not drawn again.
bool keeps_depth(const FrameSettings& settings) {
    return settings.reuses_light() &&
           std::any_of(settings.effects.begin(), settings.effects.end(), [](const EffectUse& use) {
               return use.effect->needs_depth && strength_of(use) != 0;
           });
}

/// Empty where the frame has none; says why.
ImageHandle occlusion_of(Graph& graph, const Scene& scene, const SceneHandles& declared,
                         const GBuffer& surfaces, const FrameSettings& settings, bool takes_light,
                         bool has_surroundings) {
    const float strength = std::clamp(settings.occlusion.strength * scene.occlusion, 0.0F, 2.0F);
    if (settings.without.has(Effect::occlusion)) {
        return {};
    }
    const std::string_view reason = settings.occlusion.strength <= 0 ? "its strength is 0"
                                    : scene.occlusion <= 0 ? "the scene does not ask for it"
                                    : !takes_light         ? "every surface is unlit"
                                    : !has_surroundings    ? "there is no light of surroundings"
                                                           : "";
    if (!reason.empty()) {
        graph.withhold("ambient occlusion", reason);
        return {};
    }
    return add_occlusion(graph, declared, surfaces,
                         {.strength = strength,
                          .radius = settings.occlusion.radius,
                          .samples = static_cast<std::uint32_t>(
                              std::clamp(std::lround(settings.occlusion.samples), 1L, 1024L)),
                          .cell = settings.occlusion.resolution->side});
}

} // namespace

ImageHandle render_scene(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                         Size size, FrameHandles& handles) {
    const Scene& scene = *inputs.scene;
    DeclaredScene declared = declare_scene(graph, inputs, settings, size);
    handles.shadow_maps = add_shadows(graph, declared.handles, std::move(declared.shadows));
    if (settings.view != nullptr && settings.view->geometry != nullptr) {
        std::vector<Draw> all = declared.opaque;
        all.insert(all.end(), declared.blended.begin(), declared.blended.end());
        handles.geometry = add_geometry_view(graph, declared.handles, *settings.view->geometry,
                                             size, std::move(all));
    }
    const bool filters_normals = !settings.without.has(Effect::specular_aa);
    const bool is_forward = settings.raster == Raster::forward;
    if (settings.raster == Raster::compute) {
        handles.surfaces =
            add_visibility(graph, declared.handles, size, declared.opaque, settings.visibility,
                           filters_normals, keeps_depth(settings));
    } else if (!is_forward) {
        handles.surfaces = add_gbuffer(graph, declared.handles, size, std::move(declared.opaque),
                                       filters_normals, keeps_depth(settings));
    } else {
        graph.withhold("g-buffer", "surfaces are lit as they are drawn");
    }
    handles.materials = declared.handles.materials;
    if (declared.handles.detail && !declared.handles.has_own_light) {
        graph.withhold("emission of the g-buffer", "no surface has light of its own");
    }
    LightingInputs lighting;
    lighting.takes_light = declared.takes_light;
    lighting.shadow_filter = settings.shadow_filter;
    lighting.surfaces = handles.surfaces;
    lighting.shadow_maps = handles.shadow_maps;
    lighting.surroundings = declared.surroundings;
    const bool has_surroundings = !settings.without.has(Effect::environment);
    lighting.environment =
        has_surroundings &&
        (settings.force_all || lighting.surroundings.kind != SurroundingsKind::gradient ||
         !scene.environment.is_black());
    if (has_surroundings && !lighting.environment) {
        graph.withhold("environment", "the surroundings are black");
    }
    ImageHandle lit;
    if (is_forward) {
        graph.withhold("ambient occlusion", "it needs the g-buffer");
        const ForwardPicture picture =
            add_forward(graph, declared.handles, lighting, size, std::move(declared.opaque),
                        filters_normals, keeps_depth(settings));
        lit = picture.lit;
        lighting.surfaces.depth = handles.surfaces.depth = picture.depth;
    } else {
        lighting.occlusion = handles.occlusion =
            occlusion_of(graph, scene, declared.handles, handles.surfaces, settings,
                         declared.takes_light, lighting.environment);
        lighting.lists_lights = !settings.force_all && may_list_lights(declared.handles);
        if (lighting.lists_lights) {
            graph.withhold("lights beyond their cones and reach",
                           "tile by tile: none of it is lit by them");
        }
        lit = add_lighting(graph, declared.handles, lighting);
        if (settings.view != nullptr && settings.view->counts_lights) {
            lighting.counts_lights = true;
            handles.light_counts = add_lighting(graph, declared.handles, lighting);
        }
    }
    if (declared.blended.empty()) {
        graph.withhold("see-through surfaces", "nothing in the picture lets light through");
        return lit;
    }
    return add_blended(graph, declared.handles, lighting, lit, std::move(declared.blended),
                       filters_normals);
}

} // namespace preview
