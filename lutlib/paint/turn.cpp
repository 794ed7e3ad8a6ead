#include "lutlib/paint/turn.h"

#include <array>

namespace lutlib {
namespace {

template <class T>
std::vector<T> turned_values(const std::vector<T>& values, PictureSize size, Turn turn) {
    const PictureSize to = turned(size, turn);
    std::vector<T> out(values.size());
    std::size_t i = 0;
    for (int y = 0; y < to.height; ++y) {
        for (int x = 0; x < to.width; ++x, ++i) {
            const Pixel from = before_turn({x, y}, size, turn);
            out[i] =
                values[static_cast<std::size_t>(from.y) * static_cast<std::size_t>(size.width) +
                       static_cast<std::size_t>(from.x)];
        }
    }
    return out;
}

} // namespace

std::vector<Turn> all_turns() {
    std::vector<Turn> out;
    for (const bool mirrored : {false, true}) {
        for (int quarters = 0; quarters < 4; ++quarters) {
            out.push_back({quarters, mirrored});
        }
    }
    return out;
}

PictureSize turned(PictureSize size, Turn turn) {
    return turn.quarters % 2 == 0 ? size : PictureSize{size.height, size.width};
}

Pixel before_turn(Pixel at, PictureSize size, Turn turn) {
    const PictureSize to = turned(size, turn);
    const int x = at.x, y = turn.mirrored ? to.height - 1 - at.y : at.y;
    switch (turn.quarters) {
    case 1:
        return {y, size.height - 1 - x};
    case 2:
        return {size.width - 1 - x, size.height - 1 - y};
    case 3:
        return {size.width - 1 - y, x};
    default:
        return {x, y};
    }
}

Pixel after_turn(Pixel at, PictureSize size, Turn turn) {
    const std::array<Pixel, 4> places{{at,
                                       {size.height - 1 - at.y, at.x},
                                       {size.width - 1 - at.x, size.height - 1 - at.y},
                                       {at.y, size.width - 1 - at.x}}};
    const Pixel out = places[static_cast<std::size_t>(turn.quarters)];
    return turn.mirrored ? Pixel{out.x, turned(size, turn).height - 1 - out.y} : out;
}

Picture turned(const Picture& picture, Turn turn) {
    const PictureSize to = turned(picture.size(), turn);
    return {to.width, to.height, turned_values(picture.pixels, picture.size(), turn)};
}

std::vector<float> turned(const std::vector<float>& plane, PictureSize size, Turn turn) {
    return turned_values(plane, size, turn);
}

std::string words_of(Turn turn) {
    constexpr std::array<const char*, 4> quarters{"", "turned by 90 degrees clockwise",
                                                  "turned by 180 degrees",
                                                  "turned by 90 degrees counter-clockwise"};
    const std::string first = quarters[static_cast<std::size_t>(turn.quarters)];
    return first + (turn.mirrored
                        ? std::string(first.empty() ? "" : ", then ") + "mirrored upside down"
                        : "");
}

} // namespace lutlib
