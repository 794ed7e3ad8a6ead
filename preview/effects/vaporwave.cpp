// Purple surfaces before a checkerboard.
#include "preview/effects/all.h"

#include <cmath>

namespace preview::effect {
namespace {

constexpr lutlib::Parameter vaporwave_parameters[] = {
    {.name = "strength", .flag = "strength", .label = "Strength", .fallback = 1},
    {.name = "field",
     .flag = "field",
     .label = "Side of a field of the board",
     .unit = "1/1000 h",
     .min = 5,
     .max = 500,
     .fallback = 60},
    {.name = "speed",
     .flag = "speed",
     .label = "Fields that pass",
     .unit = "1/s",
     .min = -10,
     .max = 10,
     .fallback = 0.5},
};

struct VaporwavePush {
    float strength, field, moved;
    std::uint32_t side_width;
};

ImageHandle add_vaporwave(Graph& graph, const EffectInput& in, const lutlib::Values& values) {
    const ImageDesc desc = graph.image_desc(in.picture);
    Pass pass = graph.compute("vaporwave", "vaporwave.comp");
    pass.read(in.picture);
    pass.read(in.depth.image, Neutral::white);
    const ImageHandle out = pass.write(graph.image("vaporwave", desc));
    const double fields = in.seconds * std::get<double>(values[2]);
    pass.push(VaporwavePush{number_at(values, 0),
                            number_at(values, 1) / 1000 * static_cast<float>(desc.height),
                            static_cast<float>(fields - 2 * std::floor(fields / 2)), in.width});
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

std::string_view idle_in_vaporwave(const lutlib::Values& /*values*/, std::size_t parameter,
                                   double seconds) {
    return parameter == 2 ? idle_rate(seconds) : "";
}

} // namespace

const PostEffect vaporwave{
    .name = "vaporwave",
    .label = "Vaporwave",
    .help = "Surfaces in purple and pink, and where there is none a moving checkerboard",
    .reference = "0.7 mix(dark, light, luma) + 0.3 color; fields change over one texel",
    .stage = Stage::after_look,
    .parameters = vaporwave_parameters,
    .needs_depth = true,
    .idle_parameter = idle_in_vaporwave,
    .add = add_vaporwave};

} // namespace preview::effect
