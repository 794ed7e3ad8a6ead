// A damaged transmission.
#include "preview/effects/all.h"

#include <algorithm>
#include <cmath>

namespace preview::effect {
namespace {

constexpr lutlib::Parameter glitch_parameters[] = {
    {.name = "strength", .flag = "strength", .label = "Strength", .fallback = 0.6},
    {.name = "shift",
     .flag = "shift",
     .label = "Shift of green at the borders",
     .unit = "1/1000 h",
     .min = 0,
     .max = 100,
     .fallback = 20},
    {.name = "tear",
     .flag = "tear",
     .label = "Farthest shift of a torn line",
     .unit = "1/1000 h",
     .min = 0,
     .max = 500,
     .fallback = 80},
    {.name = "static", .flag = "static", .label = "Static", .min = 0, .max = 1, .fallback = 0.2},
    {.name = "line",
     .flag = "line",
     .label = "Height of a line",
     .unit = "1/1000 h",
     .min = 1,
     .max = 50,
     .fallback = 4},
    {.name = "rate",
     .flag = "rate",
     .label = "Changes",
     .unit = "1/s",
     .min = 0,
     .max = 60,
     .fallback = 12},
};

struct GlitchPush {
    float green_shift, tear, torn_lines, noise;
    std::uint32_t moment;
    std::int32_t line, side_width;
};

ImageHandle add_glitch(Graph& graph, const EffectInput& in, const lutlib::Values& values) {
    const ImageDesc desc = graph.image_desc(in.picture);
    const float rows = static_cast<float>(desc.height), strength = number_at(values, 0);
    const auto texels = [&](std::size_t parameter) {
        return number_at(values, parameter) / 1000 * rows;
    };
    Pass pass = graph.compute("glitch", "glitch.comp");
    pass.read(in.picture);
    const ImageHandle out = pass.write(graph.image("damaged", desc));
    pass.push(GlitchPush{strength * texels(1), strength * texels(2), 0.2F * strength,
                         strength * number_at(values, 3),
                         step_at(in.seconds, std::get<double>(values[5])),
                         static_cast<std::int32_t>(std::max(std::lround(texels(4)), 1L)),
                         static_cast<std::int32_t>(in.width)});
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

std::string_view idle_in_glitch(const lutlib::Values& values, std::size_t parameter,
                                double seconds) {
    if (parameter >= 4 && number_at(values, 2) == 0 && number_at(values, 3) == 0) {
        return "nothing is torn, and there is no static";
    }
    return parameter == 5 ? idle_rate(seconds) : "";
}

} // namespace

const PostEffect glitch{
    .name = "glitch",
    .label = "Glitch",
    .help = "Green stands apart towards the borders, lines are torn, static lies over all",
    .reference = "green from x + shift e |e|, e -1..1 from border to border; a fifth of the lines "
                 "torn",
    .stage = Stage::after_look,
    .parameters = glitch_parameters,
    .idle_parameter = idle_in_glitch,
    .add = add_glitch};

} // namespace preview::effect
