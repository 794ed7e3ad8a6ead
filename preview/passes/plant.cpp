#include "preview/passes/plant.h"

namespace preview {

bool can_be_planted(const ImageDesc& desc) {
    const bool holds_floats = desc.format == Format::rgba16f || desc.format == Format::rgba32f ||
                              desc.format == Format::r32f || desc.format == Format::d32;
    return holds_floats && desc.depth == 0 && desc.layers == 0;
}

ImageHandle add_plant(Graph& graph, ImageHandle image, const Planted& planted) {
    ImageDesc desc = graph.image_desc(image);
    if (desc.format == Format::d32) {
        desc.format = Format::r32f;
    }
    Pass pass = graph.compute("plant", "plant.comp");
    pass.read(image);
    const ImageHandle out = pass.write(graph.image("planted", desc));
    pass.push(planted);
    pass.dispatch_over(desc.width, desc.height);
    return out;
}

} // namespace preview
