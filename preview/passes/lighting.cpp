#include "preview/passes/lighting.h"

namespace preview {

bool may_list_lights(const SceneHandles& scene) {
    constexpr std::uint32_t few = 8, most = 1024; // of shaders/common/light_lists.glsl
    return (scene.has_spots || scene.has_ends) && scene.light_count >= few &&
           scene.light_count <= most;
}

namespace {

/// What is not lit has neither a normal nor a colour that anybody reads.
bool takes_light(const SceneHandles& scene, const LightingInputs& inputs) {
    return inputs.takes_light && (scene.light_count > 0 || inputs.environment);
}

/// Of surroundings those that the background shows.
SurroundingsHandles seen_behind(SurroundingsHandles all) {
    all.harmonics = {};
    all.levels = all.mirror = all.reflectance = {};
    return all;
}

} // namespace

std::vector<std::uint32_t> lighting_constants(const SceneHandles& scene,
                                              const LightingInputs& inputs,
                                              std::initializer_list<std::uint32_t> own) {
    std::vector<std::uint32_t> out{inputs.shadow_maps ? 1U : 0U,
                                   inputs.environment ? 1U : 0U,
                                   scene.has_spots ? 1U : 0U,
                                   scene.has_suns ? 1U : 0U,
                                   static_cast<std::uint32_t>(inputs.surroundings.kind),
                                   inputs.occlusion ? 1U : 0U,
                                   scene.area_shapes,
                                   scene.soft_boxes,
                                   scene.has_ends ? 1U : 0U,
                                   takes_light(scene, inputs) ? 1U : 0U,
                                   inputs.shadow_filter->side,
                                   inputs.shadow_filter->places};
    out.insert(out.end(), own);
    return out;
}

void read_surroundings(Pass& pass, const SurroundingsHandles& surroundings) {
    pass.uniform(surroundings.block);
    pass.storage(surroundings.harmonics);
    pass.sample(surroundings.levels, Sampler::linear_repeat);
    pass.sample(surroundings.mirror, Sampler::linear_repeat);
    pass.sample(surroundings.picture, Sampler::linear_repeat);
    pass.sample(surroundings.reflectance, Sampler::linear_clamp);
}

ImageHandle add_lighting(Graph& graph, const SceneHandles& scene, const LightingInputs& inputs) {
    const Size size = size_of(graph, inputs.surfaces.depth);
    const bool has_detail = static_cast<bool>(inputs.surfaces.albedo);
    const bool is_lit = takes_light(scene, inputs);
    const auto if_lit = [&](ImageHandle image) { return is_lit ? image : ImageHandle{}; };
    const std::string_view name = inputs.counts_lights ? "lights a pixel" : "lighting";
    Pass pass = graph.compute(name, has_detail ? "lighting_detail.comp" : "lighting.comp");
    pass.constants(
        lighting_constants(scene, inputs,
                           {inputs.lists_lights && is_lit ? 1U : 0U, scene.has_own_light ? 1U : 0U,
                            inputs.counts_lights ? 1U : 0U}));
    pass.uniform(scene.view);
    pass.uniform(scene.environment);
    pass.storage(scene.lights);
    pass.read(inputs.surfaces.depth);
    pass.read(if_lit(inputs.surfaces.normal), Neutral::black_integer);
    const bool has_numbers = is_lit || (!has_detail && scene.has_own_light);
    pass.read(has_numbers ? inputs.surfaces.material : ImageHandle{}, Neutral::black_integer);
    if (has_detail) {
        pass.read(if_lit(inputs.surfaces.albedo));
    } else {
        pass.storage(scene.materials);
    }
    pass.sample(if_lit(inputs.shadow_maps), Sampler::nearest_clamp, Neutral::lit);
    pass.read(if_lit(inputs.occlusion), Neutral::white);
    const ImageHandle lit = pass.write(graph.image(inputs.counts_lights ? name : "lit",
                                                   {Format::rgba16f, size.width, size.height}));
    if (has_detail) {
        pass.read(scene.has_own_light ? inputs.surfaces.emission : ImageHandle{});
    }
    read_surroundings(pass, is_lit ? inputs.surroundings : seen_behind(inputs.surroundings));
    pass.push(scene.light_count);
    pass.dispatch_over(size.width, size.height);
    return lit;
}

} // namespace preview
