#include "preview/passes/picture_view.h"

#include "preview/passes/glyphs.h"

#include <algorithm>

namespace preview {

namespace {

// Of shaders/picture_view.comp.
constexpr std::size_t longest_line = 24, most_lines = 8;
constexpr std::int32_t line_dots = 9, text_starts = 10, glyph_dots = 6;

struct LegendBlock {
    std::array<std::int32_t, 4> panel{};
    std::array<std::int32_t, 4> sizes{};
    std::array<std::array<float, 4>, most_lines> colors{};
    std::array<std::uint32_t, most_lines * longest_line> characters{};
};

/// In the lower left corner; none where it would take more than the picture has.
LegendBlock legend_of(const PictureView& row, Size size) {
    const auto width = static_cast<std::int32_t>(size.width);
    const auto height = static_cast<std::int32_t>(size.height);
    const std::int32_t dot = std::max((std::min(width, height) + 180) / 360, 1);
    LegendBlock block;
    block.sizes = {dot, 0, 0, 0};
    block.characters.fill(no_glyph);
    const std::size_t lines = std::min(row.legend.size(), most_lines);
    std::size_t longest = 0;
    for (std::size_t line = 0; line < lines; ++line) {
        const LegendEntry& entry = row.legend[line];
        block.colors[line] = {entry.color[0], entry.color[1], entry.color[2], 1};
        const std::size_t count = std::min(entry.text.size(), longest_line);
        for (std::size_t i = 0; i < count; ++i) {
            block.characters[line * longest_line + i] = glyph_of(entry.text[i]);
        }
        longest = std::max(longest, count);
    }
    const std::int32_t margin = 4 * dot;
    const std::int32_t wide =
        (text_starts + static_cast<std::int32_t>(longest) * glyph_dots + 3) * dot;
    const std::int32_t high = (static_cast<std::int32_t>(lines) * line_dots + 2) * dot;
    if (lines > 0 && wide + 2 * margin <= width && high + 2 * margin <= height) {
        block.panel = {margin, height - margin - high, wide, high};
        block.sizes[1] = static_cast<std::int32_t>(lines);
    }
    return block;
}

} // namespace

ImageHandle add_picture_view(Graph& graph, const ViewedPicture& viewed, const PictureView& row,
                             float level, Format format) {
    const Size size = size_of(graph, viewed.picture);
    Pass pass = graph.compute("view of the picture", "picture_view.comp");
    pass.constants({static_cast<std::uint32_t>(index_of(row)), format == Format::rgba8});
    pass.read(viewed.picture);
    pass.read(viewed.before);
    const ImageHandle out = pass.write(graph.image("viewed", {format, size.width, size.height}));
    pass.storage(graph.data_of("legend", legend_of(row, size)));
    pass.push(level);
    pass.dispatch_over(size.width, size.height, many_each);
    return out;
}

} // namespace preview
