#include "preview/passes/magnify.h"

#include <array>

namespace preview {

namespace {

struct Push {
    std::array<std::int32_t, 2> corner;
    std::int32_t half_width; ///< of the output where it is a pair; else all of it
    float scale, surround, heat_scale;
};

} // namespace

ImageHandle add_magnify(Graph& graph, ImageHandle picture, const Magnifying& how) {
    const ImageDesc& desc = graph.image_desc(picture);
    const Size size{how.is_pair ? 2 * how.output.width : how.output.width, how.output.height};
    Pass pass = graph.compute("magnify", "magnify.comp");
    pass.constants({how.magnifier == &magnifier_smooth, how.is_pair, how.heat_scale > 0,
                    desc.format == Format::rgba8});
    pass.read(picture);
    const ImageHandle out =
        pass.write(graph.image("magnified", {desc.format, size.width, size.height}));
    pass.push(Push{{how.place.left, how.place.top},
                   static_cast<std::int32_t>(how.output.width),
                   how.place.scale,
                   surround_code,
                   how.heat_scale});
    pass.dispatch_over(size.width, size.height, many_each);
    return out;
}

} // namespace preview
