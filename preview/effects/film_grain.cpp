// The noise of film, in the finished colours.
#include "preview/effects/all.h"

#include <algorithm>

namespace preview::effect {
namespace {

constexpr lutlib::Parameter film_grain_parameters[] = {
    {.name = "strength", .flag = "strength", .label = "Strength", .fallback = 0.25},
    {.name = "size",
     .flag = "size",
     .label = "Size of a grain",
     .unit = "1/1000 h",
     .min = 0.5,
     .max = 100,
     .fallback = 1.5},
    {.name = "rate",
     .flag = "rate",
     .label = "Frames of the film",
     .unit = "1/s",
     .min = 0,
     .max = 120,
     .fallback = 24},
    {.name = "colored",
     .flag = "colored",
     .label = "In each colour",
     .kind = lutlib::ParameterKind::toggle,
     .fallback = 0},
};

struct FilmGrainPush {
    float amplitude, cell;
    std::uint32_t frame, is_colored, side_width;
};

ImageHandle add_film_grain(Graph& graph, const EffectInput& in, const lutlib::Values& values) {
    const ImageDesc desc = graph.image_desc(in.picture);
    Pass pass = graph.compute("film-grain", "film_grain.comp");
    pass.read(in.picture);
    const ImageHandle out = pass.write(graph.image("with grain", desc));
    const float cell = number_at(values, 1) / 1000 * static_cast<float>(desc.height);
    pass.push(FilmGrainPush{0.15F * number_at(values, 0), std::max(cell, 1.0F),
                            step_at(in.seconds, std::get<double>(values[2])),
                            number_at(values, 3) != 0 ? 1U : 0U, in.width});
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

std::string_view idle_in_film_grain(const lutlib::Values& /*values*/, std::size_t parameter,
                                    double seconds) {
    return parameter == 2 ? idle_rate(seconds) : "";
}

} // namespace

const PostEffect film_grain{
    .name = "film-grain",
    .label = "Film grain",
    .help = "Noise that is strongest in the middle tones, another for each frame of the film",
    .reference = "color + 0.15 strength 4 luma (1 - luma) noise, noise of variance 1 between the "
                 "points of a grid",
    .stage = Stage::after_look,
    .parameters = film_grain_parameters,
    .idle_parameter = idle_in_film_grain,
    .add = add_film_grain};

} // namespace preview::effect
