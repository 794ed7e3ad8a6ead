// A lens whose scale is another for each colour.
#include "preview/effects/all.h"

#include <cmath>

namespace preview::effect {
namespace {

constexpr lutlib::Parameter chromatic_aberration_parameters[] = {
    {.name = "strength", .flag = "strength", .label = "Strength", .fallback = 1},
    {.name = "corner",
     .flag = "corner",
     .label = "Shift in the corners",
     .unit = "1/1000 h",
     .min = 0,
     .max = 50,
     .fallback = 6},
};

struct ChromaticAberrationPush {
    float corner;
    std::uint32_t side_width;
};

ImageHandle add_chromatic_aberration(Graph& graph, const EffectInput& in,
                                     const lutlib::Values& values) {
    const ImageDesc desc = graph.image_desc(in.picture);
    const float width = static_cast<float>(in.width), height = static_cast<float>(desc.height);
    const float half_diagonal = 0.5F * std::sqrt(width * width + height * height);
    Pass pass = graph.compute("chromatic-aberration", "chromatic_aberration.comp");
    pass.constants({desc.format == Format::rgba16f});
    pass.sample(in.picture, Sampler::linear_clamp);
    const ImageHandle out = pass.write(graph.image("with fringes", desc));
    const float corner = number_at(values, 1) / 1000 * height;
    pass.push(ChromaticAberrationPush{number_at(values, 0) * corner / half_diagonal, in.width});
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

} // namespace

const PostEffect chromatic_aberration{
    .name = "chromatic-aberration",
    .label = "Chromatic aberration",
    .help = "Red and blue stand apart from green towards the corners, as a simple lens shows them",
    .reference = "red from r + k r^3, blue from r - k r^3, r the distance from the middle",
    .stage = Stage::hdr,
    .parameters = chromatic_aberration_parameters,
    .add = add_chromatic_aberration};

} // namespace preview::effect
