#include "preview/passes/occlusion.h"

#include <array>

namespace preview {

namespace {

/// A pass that makes an image of `size` from `source` and the surfaces.
ImageHandle filtered(Graph& graph, const SceneHandles& scene, const GBuffer& surfaces,
                     ImageHandle source, Size size, float radius, std::string_view name,
                     std::string_view shader, std::initializer_list<std::uint32_t> constants) {
    Pass pass = graph.compute(name, shader);
    pass.constants(constants);
    pass.uniform(scene.view);
    pass.read(surfaces.depth);
    pass.read(surfaces.normal);
    pass.read(source);
    const ImageHandle out = pass.write(graph.image(name, {Format::r32f, size.width, size.height}));
    pass.push(radius);
    pass.dispatch_over(size.width, size.height);
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
    const Size cells{(size.width + 1) / 2, (size.height + 1) / 2};
    ImageHandle out =
        pass.write(graph.image("ambient occlusion", {Format::r32f, cells.width, cells.height}));
    pass.push(std::array{inputs.radius, inputs.strength});
    pass.dispatch_over(cells.width, cells.height);
    out = filtered(graph, scene, surfaces, out, cells, inputs.radius,
                   "ambient occlusion blurred along x", "occlusion_blur.comp", {1});
    out = filtered(graph, scene, surfaces, out, cells, inputs.radius,
                   "ambient occlusion blurred along y", "occlusion_blur.comp", {0});
    return filtered(graph, scene, surfaces, out, size, inputs.radius, "ambient occlusion enlarged",
                    "occlusion_enlarge.comp", {});
}

} // namespace preview
