#include "preview/passes/shadow.h"

#include "preview/passes/pass.h"

#include <span>

namespace preview {

int ShadowMaps::add(const PointLight& light, const Scene& scene, const Geometry& geometry,
                    const LightShadow& shadow) {
    if (shadow.views.empty()) {
        return -1;
    }
    if (casters.empty()) {
        casters = caster_blocks(scene);
        materials = caster_materials(scene);
    }
    const auto first = static_cast<int>(maps.size());
    for (const ShadowView& view : shadow.views) {
        const std::string side = view.side.empty() ? "" : " towards " + std::string(view.side);
        ShadowMap map{light.name + side, shadow_clip(light, view.frustum),
                      draws_of(scene, geometry, view.casters)};
        std::uint32_t object = 0;
        std::uint32_t caster = 0;
        for (Draw& draw : map.draws) { // by object, in rising order
            for (; object < draw.first_instance; ++object) {
                caster += scene.objects[object].casts_shadow ? 1U : 0U;
            }
            draw.first_instance = caster;
        }
        maps.push_back(std::move(map));
    }
    return first;
}

ImageHandle add_shadows(Graph& graph, const SceneHandles& scene, ShadowMaps shadows) {
    if (shadows.maps.empty()) {
        return {};
    }
    const auto layers = static_cast<std::uint32_t>(shadows.maps.size());
    const ImageDesc desc{Format::d32, shadows.size, shadows.size, 0, layers};
    ImageHandle array =
        image_kept_if(graph, shadows.are_kept, "shadow maps", desc, "no light or caster has moved");
    const BufferHandle casters =
        graph.data("shadow casters", std::as_bytes(std::span(shadows.casters)));
    const bool has_cutouts = scene.detail.has_cutouts;
    const BufferHandle materials =
        has_cutouts
            ? graph.data("materials of shadow casters", std::as_bytes(std::span(shadows.materials)))
            : BufferHandle{};
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        ShadowMap& map = shadows.maps[layer];
        Pass pass = has_cutouts ? graph.raster("shadow of " + map.name, "shadow_cutout.vert",
                                               "shadow_cutout.frag")
                                : graph.raster("shadow of " + map.name, "shadow.vert", "");
        pass.storage(scene.vertices);
        pass.storage(casters);
        if (has_cutouts) {
            pass.storage(materials);
            pass.storage(scene.detail.vertices);
            pass.storage(scene.detail.materials);
            pass.storage(scene.detail.textures);
            pass.storage(scene.detail.texels);
        }
        pass.index_buffer(scene.indices);
        pass.push(map.clip);
        pass.draws(std::move(map.draws));
        // Meshes may be open, so both sides cast. No bias: the lighting pass compares each texel
        // with the surface's own plane.
        RasterState state;
        state.cull = RasterState::Cull::none;
        pass.state(state);
        array = layer == 0 ? pass.depth(array, 1, 0) : pass.depth_layer(array, 1, layer);
    }
    return array;
}

} // namespace preview
