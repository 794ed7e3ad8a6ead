#include "preview/passes/shadow.h"

namespace preview {

ImageHandle add_shadows(Graph& graph, const SceneHandles& scene, std::uint32_t size,
                        std::vector<ShadowMap> maps) {
    if (maps.empty())
        return {};
    const auto layers = static_cast<std::uint32_t>(maps.size());
    ImageHandle array = graph.image("shadow maps", {Format::d32, size, size, 0, layers});
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        ShadowMap& map = maps[layer];
        Pass pass = graph.raster("shadow of " + map.name, "shadow.vert", "");
        pass.storage(scene.vertices);
        pass.storage(scene.objects);
        pass.storage(scene.lights);
        pass.index_buffer(scene.indices);
        pass.push(map.light);
        pass.draws(std::move(map.draws));
        // Meshes may be open, so both sides cast. The bias grows with the slope; the lighting pass
        // moves along the normal for the rest.
        RasterState state;
        state.cull = RasterState::Cull::none;
        state.depth_bias_constant = 2;
        state.depth_bias_slope = 1.5F;
        pass.state(state);
        array = layer == 0 ? pass.depth(array, 1, 0) : pass.depth_layer(array, 1, layer);
    }
    return array;
}

} // namespace preview
