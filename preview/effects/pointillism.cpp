// Dots on paper.
#include "preview/effects/all.h"

#include <algorithm>
#include <cmath>

namespace preview::effect {
namespace {

constexpr lutlib::Parameter pointillism_parameters[] = {
    {.name = "strength", .flag = "strength", .label = "Strength", .fallback = 1},
    {.name = "size",
     .flag = "size",
     .label = "Side of a cell",
     .unit = "1/1000 h",
     .min = 2,
     .max = 100,
     .fallback = 12},
    {.name = "colored",
     .flag = "colored",
     .label = "Dots in colour",
     .kind = lutlib::ParameterKind::toggle,
     .fallback = 1},
};

struct CellsPush {
    float cell;
    std::uint32_t side_width, columns, samples, is_colored;
};
struct PointillismPush {
    float strength, cell;
    std::uint32_t side_width, columns;
};

constexpr float least_dot = 2; ///< texels
constexpr std::uint32_t most_samples = 8;

ImageHandle add_pointillism(Graph& graph, const EffectInput& in, const lutlib::Values& values) {
    const ImageDesc desc = graph.image_desc(in.picture);
    const float cell =
        std::max(number_at(values, 1) / 1000 * static_cast<float>(desc.height), least_dot);
    const auto cells_over = [&](std::uint32_t length) {
        return static_cast<std::uint32_t>(std::ceil(static_cast<float>(length) / cell));
    };
    const std::uint32_t columns = cells_over(in.width), sides = desc.width / in.width;
    const ImageDesc grid{Format::rgba16f, sides * columns, cells_over(desc.height)};
    Pass means = graph.compute("pointillism cells", "pointillism_cells.comp");
    means.read(in.picture);
    const ImageHandle cells = means.write(graph.image("cells", grid));
    means.push(CellsPush{cell, in.width, columns,
                         std::clamp(static_cast<std::uint32_t>(cell), 1U, most_samples),
                         number_at(values, 2) != 0 ? 1U : 0U});
    means.dispatch_over(grid.width, grid.height);

    Pass pass = graph.compute("pointillism", "pointillism.comp");
    pass.read(in.picture);
    pass.read(cells);
    const ImageHandle out = pass.write(graph.image("dots", desc));
    pass.push(PointillismPush{number_at(values, 0), cell, in.width, columns});
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

} // namespace

const PostEffect pointillism{
    .name = "pointillism",
    .label = "Pointillism",
    .help = "A dot in each cell of a grid, the larger the darker the picture is there",
    .reference = "a dot's share of its cell is 1 - min(r, g, b), or 1 - luma in black",
    .stage = Stage::after_look,
    .parameters = pointillism_parameters,
    .add = add_pointillism};

} // namespace preview::effect
