// The picture painted with strokes that follow a flow.
#include "preview/effects/all.h"

#include <algorithm>
#include <cmath>

namespace preview::effect {
namespace {

constexpr lutlib::Parameter paintbrush_parameters[] = {
    {.name = "strength", .flag = "strength", .label = "Strength", .fallback = 1},
    {.name = "size",
     .flag = "size",
     .label = "Width of a stroke",
     .unit = "1/1000 h",
     .min = 3,
     .max = 100,
     .fallback = 14},
    {.name = "length",
     .flag = "length",
     .label = "Length, of the width",
     .min = 0.7,
     .max = 2,
     .fallback = 2},
    {.name = "coherence", .flag = "coherence", .label = "Following the flow", .fallback = 0.9},
    {.name = "frequency",
     .flag = "frequency",
     .label = "Turns of the flow",
     .unit = "1/h",
     .min = 0.5,
     .max = 30,
     .fallback = 5},
    {.name = "rate",
     .flag = "rate",
     .label = "Changes of the flow",
     .unit = "1/s",
     .max = 20,
     .fallback = 1},
};

constexpr float least_cell = 2; ///< texels; of shaders/paintbrush.comp
constexpr std::uint32_t reach = 2;
constexpr float half_width = 0.7F; ///< of a stroke, in cells; shaders/common/strokes.glsl

struct StrokesPush {
    float cell, frequency, depth, coherence;
    std::uint32_t side_width, columns;
};
struct PaintbrushPush {
    float strength, cell, half_length;
    std::uint32_t side_width, columns;
};

/// Where in the noise a moment lies: from each whole number to the next, slow at both. The noise
/// repeats after 256.
float depth_at(double seconds, double rate) {
    const double steps = seconds * rate, whole = std::floor(steps), part = steps - whole;
    return static_cast<float>(whole - 256 * std::floor(whole / 256) + part * part * (3 - 2 * part));
}

ImageHandle add_paintbrush(Graph& graph, const EffectInput& in, const lutlib::Values& values) {
    const ImageDesc desc = graph.image_desc(in.picture);
    const auto rows = static_cast<float>(desc.height);
    const float cell = std::max(number_at(values, 1) / 1000 * rows / (2 * half_width), least_cell);
    const auto cells_over = [&](std::uint32_t length) {
        return static_cast<std::uint32_t>(std::ceil(static_cast<float>(length) / cell)) + 2 * reach;
    };
    const std::uint32_t columns = cells_over(in.width), sides = desc.width / in.width;
    const ImageDesc grid{Format::rgba16f, sides * columns, cells_over(desc.height)};
    Pass strokes = graph.compute("paintbrush strokes", "paintbrush_strokes.comp");
    strokes.read(in.picture);
    const ImageHandle flows = strokes.write(graph.image("flows of strokes", grid));
    const ImageHandle colors = strokes.write(graph.image("colours of strokes", grid));
    strokes.push(StrokesPush{cell, number_at(values, 4) * cell / rows,
                             depth_at(in.seconds, std::get<double>(values[5])),
                             number_at(values, 3), in.width, columns});
    strokes.dispatch_over(grid.width, grid.height);

    Pass pass = graph.compute("paintbrush", "paintbrush.comp");
    pass.read(in.picture);
    pass.read(flows);
    pass.read(colors);
    const ImageHandle out = pass.write(graph.image("painted", desc));
    pass.push(PaintbrushPush{number_at(values, 0), cell, number_at(values, 2) * half_width,
                             in.width, columns});
    pass.dispatch(sides * ((in.width + 15) / 16), (desc.height + 15) / 16);
    return out;
}

std::string_view idle_in_paintbrush(const lutlib::Values& values, std::size_t parameter,
                                    double seconds) {
    if (parameter >= 4 && number_at(values, 3) == 0) {
        return "strokes do not follow the flow (coherence=0)";
    }
    return parameter == 5 ? idle_rate(seconds) : "";
}

} // namespace

const PostEffect paintbrush{
    .name = "paintbrush",
    .label = "Paintbrush",
    .help = "Strokes along a flow, each in the colour that the picture has there",
    .reference = "Bridson, Houriham and Nordenstam 2007, Curl-noise for procedural fluid flow; "
                 "strokes sum w color / sum w",
    .stage = Stage::after_look,
    .parameters = paintbrush_parameters,
    .idle_parameter = idle_in_paintbrush,
    .add = add_paintbrush};

} // namespace preview::effect
