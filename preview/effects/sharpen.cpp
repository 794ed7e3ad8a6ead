// Sharpening of the finished picture.
#include "preview/effects/all.h"

#include <algorithm>
#include <cmath>

namespace preview::effect {
namespace {

constexpr lutlib::Parameter sharpen_parameters[] = {
    {.name = "strength", .flag = "strength", .label = "Strength", .fallback = 0.6},
    {.name = "reach",
     .flag = "reach",
     .label = "Distance of the neighbours",
     .unit = "1/1000 h",
     .min = 0.1,
     .max = 100,
     .fallback = 0.926},
};

struct SharpenPush {
    float strength;
    std::int32_t reach, side_width;
};

ImageHandle add_sharpen(Graph& graph, const EffectInput& in, const lutlib::Values& values) {
    const ImageDesc desc = graph.image_desc(in.picture);
    Pass pass = graph.compute("sharpen", "sharpen.comp");
    pass.read(in.picture);
    const ImageHandle out = pass.write(graph.image("sharpened", desc));
    const double texels = std::get<double>(values[1]) / 1000 * desc.height;
    pass.push(SharpenPush{number_at(values, 0),
                          static_cast<std::int32_t>(std::max(std::lround(texels), 1L)),
                          static_cast<std::int32_t>(in.width)});
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

} // namespace

const PostEffect sharpen{.name = "sharpen",
                         .label = "Sharpening",
                         .help = "Raises the contrast of details, less where there is much",
                         .reference = "AMD FidelityFX Contrast Adaptive Sharpening 2019, by the "
                                      "cross of four neighbours",
                         .stage = Stage::after_look,
                         .parameters = sharpen_parameters,
                         .add = add_sharpen};

} // namespace preview::effect
