#include "lutlib/io/orientation.h"

#include <algorithm>
#include <utility>

namespace lutlib::io {
namespace {

// Where the pixel of an upright picture is stored: first swapped, then mirrored.
struct Turn {
    bool swapped = false, mirrored_x = false, mirrored_y = false;
};
constexpr std::array<Turn, 8> turns{{
    {false, false, false},
    {false, true, false},
    {false, true, true},
    {false, false, true},
    {true, false, false},
    {true, false, true},
    {true, true, true},
    {true, true, false},
}};

} // namespace

FloatImage upright(const FloatImage& stored, int orientation) {
    if (orientation < 2 || orientation > 8) {
        return stored;
    }
    const Turn turn = turns[static_cast<std::size_t>(orientation) - 1];
    FloatImage out = stored;
    if (turn.swapped) {
        std::swap(out.width, out.height);
    }
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            int from_x = turn.swapped ? y : x, from_y = turn.swapped ? x : y;
            from_x = turn.mirrored_x ? stored.width - 1 - from_x : from_x;
            from_y = turn.mirrored_y ? stored.height - 1 - from_y : from_y;
            const auto pixel = [](int px, int py, int width) {
                return 4 * (static_cast<std::size_t>(py) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(px));
            };
            std::copy_n(stored.rgba.begin() +
                            static_cast<std::ptrdiff_t>(pixel(from_x, from_y, stored.width)),
                        4, out.rgba.begin() + static_cast<std::ptrdiff_t>(pixel(x, y, out.width)));
        }
    }
    return out;
}

} // namespace lutlib::io
