#include "lutlib/paint/frame.h"

#include "lutlib/error.h"
#include "lutlib/limits.h"

#include <algorithm>
#include <string>

namespace lutlib {
namespace {

constexpr std::array<int, sync_cells> barker{1, 1, 1, 1, 1, 0, 0, 1, 1, 0, 1, 0, 1};
constexpr int row_bits = 1, depth_bits = 1, layout_bits = 3, size_bits = 9, check_bits = 8;
constexpr int payload_bits = row_bits + depth_bits + layout_bits + size_bits;
static_assert(sync_cells + payload_bits + check_bits == mark_cells);

// Files outlive the order of a table, so a mark has numbers of its own.
constexpr std::array<std::string_view, 6> layout_numbers{"strip", "strip-up", "strip-vertical",
                                                         "ocio",  "hald",     "tiles"};

// CRC-8 of the polynomial x^8 + x^2 + x + 1 (ITU-T I.432.1), begun with ones.
unsigned check_sum(unsigned payload) {
    unsigned out = 0xFF;
    for (int bit = payload_bits - 1; bit >= 0; --bit) {
        const bool one = ((payload >> bit) & 1U) != ((out >> 7) & 1U);
        out = (out << 1 & 0xFFU) ^ (one ? 0x07U : 0U);
    }
    return out;
}

} // namespace

MarkRow mark_row(const Framed& framed, int row) {
    const auto number = static_cast<unsigned>(
        std::find(layout_numbers.begin(), layout_numbers.end(), framed.layout->name) -
        layout_numbers.begin());
    if (number >= layout_numbers.size()) {
        throw Error("marks know no layout '" + std::string(framed.layout->name) + "'");
    }
    const unsigned deep = framed.bits == 16 ? 1 : 0;
    const unsigned payload = (static_cast<unsigned>(row) << depth_bits | deep)
                                 << (layout_bits + size_bits) |
                             number << size_bits | static_cast<unsigned>(framed.size);
    const unsigned word = payload << check_bits | check_sum(payload);
    MarkRow out{};
    for (int i = 0; i < mark_cells; ++i) {
        out[static_cast<std::size_t>(i)] = i < sync_cells
                                               ? barker[static_cast<std::size_t>(i)] != 0
                                               : (word >> (mark_cells - 1 - i) & 1U) != 0;
    }
    return out;
}

std::optional<MarkReading> read_mark(const MarkRow& cells) {
    unsigned word = 0;
    for (int i = 0; i < mark_cells; ++i) {
        const bool cell = cells[static_cast<std::size_t>(i)];
        if (i < sync_cells) {
            if (cell != (barker[static_cast<std::size_t>(i)] != 0)) {
                return std::nullopt;
            }
        } else {
            word = word << 1 | (cell ? 1U : 0U);
        }
    }
    const unsigned payload = word >> check_bits;
    const unsigned number = payload >> size_bits & 7U;
    const int size = static_cast<int>(payload & 0x1FFU);
    if (check_sum(payload) != (word & 0xFFU) || number >= layout_numbers.size()) {
        return std::nullopt;
    }
    const Layout* const layout = layout_named(layout_numbers[number]);
    if (!layout || size < limits::min_cube_size || size > limits::max_cube_size ||
        !layout->picture(size)) {
        return std::nullopt;
    }
    const unsigned above = payload >> (layout_bits + size_bits);
    return MarkReading{{layout, size, (above & 1U) != 0 ? 16 : 8},
                       static_cast<int>(above >> depth_bits)};
}

FrameGeometry geometry_of(const Framed& framed) {
    check_cube_size(framed.size);
    const std::optional<PictureSize> strip = framed.layout->picture(framed.size);
    if (!strip) {
        throw Error("the layout '" + std::string(framed.layout->name) +
                    "' has no picture of size " + std::to_string(framed.size) + "; its sizes are " +
                    std::string(framed.layout->sizes));
    }
    const int mark_height = 2 * mark_cell;
    FrameGeometry out;
    out.strip = *strip;
    out.mark_at = {quiet_width, quiet_width};
    out.strip_at = {quiet_width, 2 * quiet_width + mark_height};
    out.frame = {std::max(strip->width, mark_cells * mark_cell) + 2 * quiet_width,
                 strip->height + 3 * quiet_width + mark_height};
    return out;
}

CodeImage neutral_frame(const Framed& framed) {
    const CodeDepth depth{framed.bits};
    const FrameGeometry where = geometry_of(framed);
    const auto code = [depth](int of_8_bits) {
        return static_cast<std::uint16_t>(of_8_bits * depth.maximum() / 255);
    };
    CodeImage out;
    out.width = where.frame.width;
    out.height = where.frame.height;
    out.depth = depth;
    out.samples.assign(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) *
                           3,
                       code(quiet_code));
    for (int row = 0; row < 2; ++row) {
        const MarkRow cells = mark_row(framed, row);
        for (int y = 0; y < mark_cell; ++y) {
            for (int x = 0; x < mark_cells * mark_cell; ++x) {
                const bool light = cells[static_cast<std::size_t>(x / mark_cell)];
                for (std::size_t c = 0; c < 3; ++c) {
                    out.at({where.mark_at.x + x, where.mark_at.y + row * mark_cell + y}, c) =
                        code(light ? light_code : dark_code);
                }
            }
        }
    }
    const Picture strip = to_picture(identity_cube(framed.size), *framed.layout);
    for (int y = 0; y < strip.height; ++y) {
        for (int x = 0; x < strip.width; ++x) {
            const RgbD value = to_double(strip.at(x, y));
            for (std::size_t c = 0; c < 3; ++c) {
                out.at({where.strip_at.x + x, where.strip_at.y + y}, c) = depth.code(value[c]);
            }
        }
    }
    return out;
}

} // namespace lutlib
