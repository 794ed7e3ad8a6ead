#include "preview/window/thumbnail_place.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace preview {

namespace {

struct Span {
    std::int32_t from_begin = 0, from_end = 0, to_begin = 0, to_end = 0;
};

/// Along an axis: `begin` and `length` in the window's pixels, of a picture of `texels`.
Span clipped(float begin, float length, float clip_begin, float clip_end, std::uint32_t texels,
             std::uint32_t target) {
    const auto pixel = [](float at) { return static_cast<std::int32_t>(std::lround(at)); };
    const std::int32_t first = pixel(begin);
    const std::int32_t last = first + std::max(pixel(length), 1);
    const auto per_pixel = static_cast<double>(texels) / static_cast<double>(last - first);
    Span out;
    out.to_begin = std::max({first, pixel(clip_begin), 0});
    out.to_end = std::min({last, pixel(clip_end), static_cast<std::int32_t>(target)});
    const auto texel = [&](std::int32_t at) {
        return static_cast<std::int32_t>(
            std::clamp(std::round(static_cast<double>(at - first) * per_pixel), 0.0,
                       static_cast<double>(texels)));
    };
    out.from_begin = texel(out.to_begin);
    out.from_end = texel(out.to_end);
    if (out.from_end <= out.from_begin) {
        out.to_end = out.to_begin; // less than a texel is seen
    }
    return out;
}

} // namespace

ThumbnailPlace place_in(const panels::PlacedThumbnail& placed, FramebufferScale scale, Size picture,
                        Size target) {
    const Span across =
        clipped(placed.x * scale.x, placed.width * scale.x, placed.clip_left * scale.x,
                placed.clip_right * scale.x, picture.width, target.width);
    const Span down =
        clipped(placed.y * scale.y, placed.height * scale.y, placed.clip_top * scale.y,
                placed.clip_bottom * scale.y, picture.height, target.height);
    return {{across.from_begin, down.from_begin, across.from_end, down.from_end},
            {across.to_begin, down.to_begin, across.to_end, down.to_end}};
}

} // namespace preview
