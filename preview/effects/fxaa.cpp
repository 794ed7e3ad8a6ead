// Fast approximate antialiasing of the finished picture.
#include "preview/effects/all.h"

namespace preview::effect {
namespace {

constexpr lutlib::Parameter fxaa_parameters[] = {
    {.name = "strength", .flag = "strength", .label = "Strength", .fallback = 1},
};

ImageHandle add_fxaa(Graph& graph, const EffectInput& in, const lutlib::Values& values) {
    const ImageDesc desc = graph.image_desc(in.picture);
    Pass pass = graph.compute("fxaa", "fxaa.comp");
    pass.read(in.picture);
    const ImageHandle out = pass.write(graph.image("antialiased", desc));
    pass.push(static_cast<float>(std::get<double>(values[0])));
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

} // namespace

const PostEffect fxaa{.name = "fxaa",
                      .label = "Antialiasing (FXAA)",
                      .help = "Smooths the stairs of edges; strength scales how far",
                      .reference = "Lottes 2011, FXAA 3.11, quality preset",
                      .stage = Stage::last,
                      .parameters = fxaa_parameters,
                      .usual_for_scenes = true,
                      .add = add_fxaa};

} // namespace preview::effect
