#include "preview/passes/forward.h"

namespace preview {

namespace {

struct PushBlock {
    std::uint32_t light_count, width, height;
};

/// A pass of lit surfaces but for its targets. `depths`: what may hide them; empty: nothing does.
Pass surfaces_pass(Graph& graph, std::string_view name, const SceneHandles& scene,
                   const LightingInputs& inputs, ImageHandle depths, Size size,
                   bool filters_normals) {
    const bool has_detail = static_cast<bool>(scene.detail);
    Pass pass = has_detail ? graph.raster(name, "gbuffer_detail.vert", "forward_detail.frag")
                           : graph.raster(name, "gbuffer.vert", "forward.frag");
    LightingInputs without_occlusion = inputs;
    without_occlusion.occlusion = {};
    pass.constants(lighting_constants(scene, without_occlusion,
                                      {filters_normals ? 1U : 0U, depths ? 1U : 0U}));
    pass.storage(scene.vertices);
    pass.storage(scene.objects);
    pass.uniform(scene.view);
    if (has_detail) {
        read_detail(pass, scene);
    } else {
        pass.storage(scene.materials);
    }
    pass.uniform(scene.environment);
    pass.storage(scene.lights);
    pass.sample(inputs.shadow_maps, Sampler::nearest_clamp, Neutral::lit);
    pass.read(depths, Neutral::white);
    read_surroundings(pass, inputs.surroundings);
    pass.push(PushBlock{scene.light_count, size.width, size.height});
    pass.index_buffer(scene.indices);
    return pass;
}

} // namespace

ImageHandle add_blended(Graph& graph, const SceneHandles& scene, const LightingInputs& inputs,
                        ImageHandle lit, std::vector<Draw> draws, bool filters_normals) {
    Pass pass = surfaces_pass(graph, "see-through surfaces", scene, inputs, inputs.surfaces.depth,
                              size_of(graph, lit), filters_normals);
    RasterState state;
    state.blends = true;
    state.depth_test = false;
    state.depth_write = false;
    pass.state(state);
    pass.draws(std::move(draws));
    return pass.color_over(lit);
}

ForwardPicture add_forward(Graph& graph, const SceneHandles& scene, const LightingInputs& inputs,
                           Size size, std::vector<Draw> draws, bool filters_normals,
                           bool keeps_depth) {
    Pass behind = graph.compute("background", "background.comp");
    behind.constants(lighting_constants(scene, inputs, {}));
    behind.uniform(scene.view);
    behind.uniform(scene.environment);
    ForwardPicture out;
    out.lit = behind.write(graph.image("lit", {Format::rgba16f, size.width, size.height}));
    read_surroundings(behind, inputs.surroundings);
    behind.dispatch_over(size.width, size.height);

    Pass pass = surfaces_pass(graph, "forward", scene, inputs, {}, size, filters_normals);
    pass.draws(std::move(draws));
    out.lit = pass.color_over(out.lit);
    out.depth = pass.depth(depth_image(graph, Format::d32, size, keeps_depth), 1);
    return out;
}

} // namespace preview
