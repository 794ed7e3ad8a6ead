#include "preview/window/window_place.h"

#include <algorithm>
#include <cstdint>

namespace preview {

namespace {

/// What of `work` is left for a window within its frame.
DesktopArea room_in(const DesktopArea& work, const FrameWidths& frame) {
    return {work.x + frame.left, work.y + frame.top,
            std::max(work.width - frame.left - frame.right, 1),
            std::max(work.height - frame.top - frame.bottom, 1)};
}

std::int64_t common(const DesktopArea& a, const DesktopArea& b) {
    const auto length = [](std::int64_t from, std::int64_t size, std::int64_t other,
                           std::int64_t other_size) {
        return std::max(std::min(from + size, other + other_size) - std::max(from, other),
                        std::int64_t{0});
    };
    return length(a.x, a.width, b.x, b.width) * length(a.y, a.height, b.y, b.height);
}

} // namespace

DesktopArea first_area(Size usual, const FrameWidths& frame, const DesktopArea& work) {
    const DesktopArea room = room_in(work, frame);
    const int width = std::min(static_cast<int>(usual.width), room.width);
    const int height = std::min(static_cast<int>(usual.height), room.height);
    return {room.x + (room.width - width) / 2, room.y + (room.height - height) / 2, width, height};
}

DesktopArea area_again(const DesktopArea& last, const FrameWidths& frame,
                       std::span<const DesktopArea> works) {
    const DesktopArea& work =
        *std::max_element(works.begin(), works.end(), [&](const auto& a, const auto& b) {
            return common(a, last) < common(b, last);
        });
    const DesktopArea room = room_in(work, frame);
    const int width = std::clamp(last.width, 1, room.width);
    const int height = std::clamp(last.height, 1, room.height);
    return {std::clamp(last.x, room.x, room.x + room.width - width),
            std::clamp(last.y, room.y, room.y + room.height - height), width, height};
}

} // namespace preview
