#include "preview/passes/still.h"

#include "preview/finish/fit.h"
#include "preview/passes/magnify.h"
#include "preview/passes/resolve.h"

namespace preview {

namespace {

constexpr std::uint64_t figures_bytes = sizeof(std::uint32_t) * (1 + DifferenceBins::count);

struct Push {
    WipeShape wipe;
    std::array<std::int32_t, 4> extent_a, extent_b;
    std::array<std::int32_t, 2> size;
    float heat_scale, surround;
};

} // namespace

StillSide add_fitted_still(Graph& graph, ImageHandle still, Size size, const StillFit& how) {
    const Size own = size_of(graph, still);
    if (own == size) {
        return {still, size};
    }
    // Half floats hold what 8 bits can.
    const Format format = how.of_output == Format::rgba8 ? Format::rgba16f : Format::rgba32f;
    const Resolved made =
        add_resolve(graph, still, size, 1,
                    {.format = format,
                     .is_kept = how.is_kept,
                     .measures = false,
                     .name = how.name,
                     .still_right = "the still and the picture's size are the same"});
    return {made.hdr, fitted(own, size)};
}

std::array<std::int32_t, 4> place_of(Size extent, Size size) {
    const auto half = [](std::uint32_t room) { return static_cast<std::int32_t>(room / 2); };
    return {half(size.width - extent.width), half(size.height - extent.height),
            static_cast<std::int32_t>(extent.width), static_cast<std::int32_t>(extent.height)};
}

Finished add_still_comparison(Graph& graph, const std::array<StillSide, 2>& sides, Size size,
                              const StillSettings& settings) {
    const bool is_pair = settings.compare == &compare_side;
    const bool is_difference = settings.compare == &compare_difference;
    Finished out;
    BufferHandle figures = graph.buffer("figures", is_difference ? figures_bytes : 8);
    if (is_difference) {
        figures = graph.fill("clear figures", figures, 0);
    }
    Pass pass = graph.compute("compare with a still", "still.comp");
    pass.constants({static_cast<std::uint32_t>(index_of(*settings.compare)), settings.has_marks,
                    is_difference, settings.format == Format::rgba8});
    pass.read(sides[0].picture);
    pass.read(sides[1].picture);
    out.picture = pass.write(
        graph.image("compared with a still",
                    {settings.format, is_pair ? 2 * size.width : size.width, size.height}));
    figures = is_difference ? pass.modify(figures) : pass.write(figures);
    if (is_difference) {
        out.figures = figures;
    }
    pass.push(Push{settings.wipe,
                   place_of(sides[0].extent, size),
                   place_of(sides[1].extent, size),
                   {static_cast<std::int32_t>(size.width), static_cast<std::int32_t>(size.height)},
                   settings.heat_scale,
                   surround_code});
    pass.dispatch_over(size.width, size.height, many_each);
    return out;
}

} // namespace preview
