#include "preview/passes/lighting.h"

namespace preview {

bool may_list_lights(const SceneHandles& scene) {
    constexpr std::uint32_t few = 8, most = 1024; // of shaders/common/light_lists.glsl
    return scene.has_spots && scene.light_count >= few && scene.light_count <= most;
}

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
                                   scene.soft_boxes};
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
    Pass pass = graph.compute("lighting", has_detail ? "lighting_detail.comp" : "lighting.comp");
    pass.constants(lighting_constants(scene, inputs, {inputs.lists_lights}));
    pass.uniform(scene.view);
    pass.uniform(scene.environment);
    pass.storage(scene.lights);
    pass.read(inputs.surfaces.depth);
    pass.read(inputs.surfaces.normal);
    pass.read(inputs.surfaces.material);
    if (has_detail) {
        pass.read(inputs.surfaces.albedo);
    } else {
        pass.storage(scene.materials);
    }
    pass.sample(inputs.shadow_maps, Sampler::nearest_clamp, Neutral::lit);
    pass.read(inputs.occlusion, Neutral::white);
    const ImageHandle lit =
        pass.write(graph.image("lit", {Format::rgba16f, size.width, size.height}));
    if (has_detail) {
        pass.read(inputs.surfaces.emission);
    }
    read_surroundings(pass, inputs.surroundings);
    pass.push(scene.light_count);
    pass.dispatch_over(size.width, size.height);
    return lit;
}

} // namespace preview
