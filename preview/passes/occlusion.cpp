#include "preview/passes/occlusion.h"

#include <array>

namespace preview {

namespace {

ImageHandle blurred(Graph& graph, const SceneHandles& scene, const GBuffer& surfaces,
                    ImageHandle source, float radius, bool is_along_x) {
    const ImageDesc& desc = graph.image_desc(source);
    const std::string name =
        std::string("ambient occlusion blurred along ") + (is_along_x ? "x" : "y");
    Pass pass = graph.compute(name, "occlusion_blur.comp");
    pass.constants({is_along_x ? 1U : 0U});
    pass.uniform(scene.view);
    pass.read(surfaces.depth);
    pass.read(surfaces.normal);
    pass.read(source);
    const ImageHandle out = pass.write(graph.image(name, desc));
    pass.push(radius);
    pass.dispatch_over(desc.width, desc.height);
    return out;
}

} // namespace

ImageHandle add_occlusion(Graph& graph, const SceneHandles& scene, const GBuffer& surfaces,
                          const OcclusionInputs& inputs) {
    const Size size = size_of(graph, surfaces.depth);
    Pass pass = graph.compute("ambient occlusion", "occlusion.comp");
    pass.constants({inputs.samples});
    pass.uniform(scene.view);
    pass.read(surfaces.depth);
    pass.read(surfaces.normal);
    ImageHandle out =
        pass.write(graph.image("ambient occlusion", {Format::r32f, size.width, size.height}));
    pass.push(std::array{inputs.radius, inputs.strength});
    pass.dispatch_over(size.width, size.height);
    for (const bool is_along_x : {true, false}) {
        out = blurred(graph, scene, surfaces, out, inputs.radius, is_along_x);
    }
    return out;
}

} // namespace preview
