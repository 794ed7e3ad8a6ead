// The fall of light towards the corners that a simple lens has.
#include "preview/effects/all.h"

#include <cmath>
#include <numbers>

namespace preview::effect {
namespace {

constexpr lutlib::Parameter vignette_parameters[] = {
    {.name = "strength", .flag = "strength", .label = "Strength", .fallback = 1},
    {.name = "angle",
     .flag = "angle",
     .label = "Angle of view, corner to corner",
     .unit = "degrees",
     .min = 10,
     .max = 150,
     .fallback = 60},
};

struct VignettePush {
    float strength, corner_tangent;
    std::uint32_t side_width;
};

ImageHandle add_vignette(Graph& graph, const EffectInput& in, const lutlib::Values& values) {
    const ImageDesc desc = graph.image_desc(in.picture);
    const double half_angle = std::get<double>(values[1]) / 2 * std::numbers::pi / 180;
    Pass pass = graph.compute("vignette", "vignette.comp");
    pass.constants({desc.format == Format::rgba16f});
    pass.read(in.picture);
    const ImageHandle out = pass.write(graph.image("vignetted", desc));
    pass.push(VignettePush{static_cast<float>(std::get<double>(values[0])),
                           static_cast<float>(std::tan(half_angle)), in.width});
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

} // namespace

const PostEffect vignette{
    .name = "vignette",
    .label = "Vignette",
    .help = "Darkens towards the corners as a simple lens does",
    .reference = "Gardner 1947, Validity of the Cosine-Fourth-Power Law of Illumination: "
                 "light (1 - strength + strength cos^4)",
    .stage = Stage::hdr,
    .parameters = vignette_parameters,
    .add = add_vignette};

} // namespace preview::effect
