#include "preview/passes/names.h"

#include "preview/passes/glyphs.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace preview {

namespace {

constexpr std::size_t longest = 40; ///< of shaders/names.comp

struct NamesBlock {
    std::array<std::array<std::int32_t, 4>, 2> panels{};
    std::array<std::int32_t, 4> dot_size{};
    std::array<std::uint32_t, 2 * longest> characters{};
};

/// A character of UTF-8 is one, whatever its length.
std::string characters_of(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xC0U) != 0x80U) {
            out += byte < 0x80U ? c : '?';
        }
    }
    return out;
}

using Sides = std::array<std::int32_t, 2>; // width and height, or x and y

/// Where the panel of a side's name stands.
Sides corner_of(std::size_t side, const Compare& compare, const WipeShape& wipe, Sides picture,
                Sides panel, std::int32_t margin) {
    const std::int32_t right = picture[0] - margin - panel[0];
    const std::int32_t bottom = picture[1] - margin - panel[1];
    const bool is_b = side == 1;
    if (&compare == &compare_side) {
        return {is_b ? picture[0] / 2 + margin : margin, margin};
    }
    if (&compare == &compare_box) {
        const auto in_box = [&](std::size_t axis, std::int32_t most) {
            return std::clamp(static_cast<std::int32_t>(wipe[axis]) + margin, margin,
                              std::max(most, margin));
        };
        return is_b ? Sides{right, margin} : Sides{in_box(0, right), in_box(1, bottom)};
    }
    // A line that lies more than it stands has its sides above each other.
    const bool is_turned = wipe[0] < 0;
    const bool is_lying = std::abs(wipe[1]) > std::abs(wipe[0]);
    const bool is_low = is_lying && is_b == (wipe[1] > 0);
    return {is_b != is_turned ? right : margin, is_low ? bottom : margin};
}

} // namespace

ImageHandle add_names(Graph& graph, ImageHandle picture, const Compare& compare,
                      std::array<std::string_view, 2> names, const WipeShape& wipe) {
    const ImageDesc desc = graph.image_desc(picture);
    const auto width = static_cast<std::int32_t>(desc.width);
    const auto height = static_cast<std::int32_t>(desc.height);
    NamesBlock block;
    const std::int32_t dot = std::max((std::min(width, height) + 180) / 360, 1);
    block.dot_size[0] = dot;
    const std::int32_t step = 6 * dot;
    const std::int32_t margin = 4 * dot;
    const std::int32_t room = std::max((width / 2 - 2 * margin - 3 * dot) / step, 0);
    for (std::size_t side = 0; side < 2; ++side) {
        const std::string text =
            characters_of((side == 0 ? "A: " : "B: ") + std::string(names[side]));
        const std::size_t count = std::min({text.size(), longest, static_cast<std::size_t>(room)});
        for (std::size_t i = 0; i < count; ++i) {
            block.characters[side * longest + i] = glyph_of(text[i]);
        }
        std::fill(block.characters.begin() + static_cast<std::ptrdiff_t>(side * longest + count),
                  block.characters.begin() + static_cast<std::ptrdiff_t>((side + 1) * longest),
                  no_glyph);
        const std::int32_t wide =
            count == 0 ? 0 : static_cast<std::int32_t>(count) * step + 3 * dot;
        const std::array<std::int32_t, 2> corner =
            corner_of(side, compare, wipe, {width, height}, {wide, 10 * dot}, margin);
        block.panels[side] = {corner[0], corner[1], wide, count == 0 ? 0 : 10 * dot};
    }
    Pass pass = graph.compute("names", "names.comp");
    pass.read(picture);
    const ImageHandle out = pass.write(graph.image("with names", desc));
    pass.storage(graph.data_of("names of looks", block));
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

} // namespace preview
