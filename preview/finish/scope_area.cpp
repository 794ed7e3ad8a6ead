#include "preview/finish/scope_area.h"

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

/// How far a texel's middle lies on side B of the border; negative on side A.
float beyond_border(const ScopeArea& area, std::uint32_t column, std::uint32_t row) {
    const float x = static_cast<float>(column) + 0.5F, y = static_cast<float>(row) + 0.5F;
    const WipeShape& border = area.border;
    const bool is_box = area.part == ScopePart::in_box || area.part == ScopePart::around_box;
    return is_box ? std::max(std::max(border[0] - x, x - border[2]),
                             std::max(border[1] - y, y - border[3]))
                  : x * border[0] + y * border[1] - border[2];
}

bool counts_corners(const ScopeArea& area, bool all) {
    const std::uint32_t right = area.x + area.width - 1, bottom = area.y + area.height - 1;
    const std::array<bool, 4> corners{
        is_counted(area, area.x, area.y), is_counted(area, right, area.y),
        is_counted(area, area.x, bottom), is_counted(area, right, bottom)};
    return all ? std::all_of(corners.begin(), corners.end(), [](bool is) { return is; })
               : std::any_of(corners.begin(), corners.end(), [](bool is) { return is; });
}

/// Cuts columns and rows off the rectangle that have no texel which counts: what counts of a line's
/// side reaches the rectangle's edge, what counts in a box is a rectangle.
ScopeArea shrunk(ScopeArea area) {
    const bool is_box = area.part == ScopePart::in_box;
    // Of a box, the texel of a column that lies in its middle, where the rectangle reaches that.
    const auto middle = [](float low, float high, std::uint32_t begin, std::uint32_t length) {
        const float at = std::clamp((low + high) / 2, static_cast<float>(begin),
                                    static_cast<float>(begin + length - 1));
        return static_cast<std::uint32_t>(at);
    };
    const auto column_counts = [&](std::uint32_t x) {
        if (is_box) {
            return is_counted(area, x, middle(area.border[1], area.border[3], area.y, area.height));
        }
        return is_counted(area, x, area.y) || is_counted(area, x, area.y + area.height - 1);
    };
    const auto row_counts = [&](std::uint32_t y) {
        if (is_box) {
            return is_counted(area, middle(area.border[0], area.border[2], area.x, area.width), y);
        }
        return is_counted(area, area.x, y) || is_counted(area, area.x + area.width - 1, y);
    };
    const auto shrink = [](std::uint32_t& begin, std::uint32_t& length, const auto& is_in) {
        while (length > 0 && !is_in(begin)) {
            ++begin;
            --length;
        }
        while (length > 0 && !is_in(begin + length - 1)) {
            --length;
        }
    };
    shrink(area.x, area.width, column_counts);
    if (area.width > 0) {
        shrink(area.y, area.height, row_counts);
    }
    return area;
}

/// What of the area lies on one side of the comparison's border.
ScopeArea on_side(ScopeArea area, bool is_a, const Compare& compare, const WipeShape& border,
                  std::uint32_t height) {
    if (area.is_empty()) {
        return area;
    }
    const bool is_box = &compare == &compare_box;
    area.part = is_box ? (is_a ? ScopePart::in_box : ScopePart::around_box)
                       : (is_a ? ScopePart::before_line : ScopePart::behind_line);
    area.border = border;
    // As wide as shaders/common/wipe.glsl draws it, and antialiasing blends one texel beside it.
    area.reach = std::max(static_cast<float>(height) / 1080, 0.5F) + 1;
    if (area.part == ScopePart::around_box) {
        return counts_corners(area, false) ? area : ScopeArea{};
    }
    area = shrunk(area);
    if (area.is_empty()) {
        return {};
    }
    if (counts_corners(area, true)) {
        area.part = ScopePart::all;
        area.border = {};
        area.reach = 0;
    }
    return area;
}

} // namespace

bool is_counted(const ScopeArea& area, std::uint32_t x, std::uint32_t y) {
    switch (area.part) {
    case ScopePart::before_line:
    case ScopePart::in_box:
        return beyond_border(area, x, y) < -area.reach;
    case ScopePart::behind_line:
    case ScopePart::around_box:
        return beyond_border(area, x, y) > area.reach;
    case ScopePart::all:
        break;
    }
    return true;
}

ScopeArea texels_of(const ScopeRegion& region, Size picture) {
    const auto edge = [](float share, std::uint32_t length, std::uint32_t least) {
        const double at = std::round(static_cast<double>(share) * length);
        return static_cast<std::uint32_t>(
            std::clamp(at, static_cast<double>(least), static_cast<double>(length)));
    };
    ScopeArea out;
    out.x = std::min(edge(region.x, picture.width, 0), picture.width - 1);
    out.y = std::min(edge(region.y, picture.height, 0), picture.height - 1);
    out.width = edge(region.x + region.width, picture.width, out.x + 1) - out.x;
    out.height = edge(region.y + region.height, picture.height, out.y + 1) - out.y;
    return out;
}

ScopeArea scope_area(const ScopeSide& side, const Compare& compare, const Wipe& wipe,
                     const ScopeRegion& region, Size output) {
    if (&compare == &compare_difference) {
        return {};
    }
    const bool is_pair = &compare == &compare_side;
    const Size picture{is_pair ? output.width / 2 : output.width, output.height};
    ScopeArea area = texels_of(region, picture);
    if (&side == &scope_side_shown) {
        area.copies = is_pair ? 2 : 1;
        area.stride = is_pair ? picture.width : 0;
        return area;
    }
    const bool is_a = &side == &scope_sides[1];
    if (!(is_a ? compare.shows_a : compare.shows_b)) {
        return {};
    }
    if (is_pair) {
        area.x += is_a ? 0 : picture.width;
    } else if (compare.shows_one) {
        area = on_side(area, is_a, compare, wipe_shape(wipe, compare, picture), picture.height);
    }
    return area;
}

std::string_view no_scope_because(const ScopeArea& area, const ScopeSide& side,
                                  const Compare& compare, const ScopeRegion& region) {
    if (!area.is_empty()) {
        return {};
    }
    if (&compare == &compare_difference) {
        return "a heat map has no code values to count";
    }
    const bool is_shown = &side == &scope_sides[1] ? compare.shows_a : compare.shows_b;
    return !is_shown                 ? "its side is not shown"
           : region == ScopeRegion{} ? "the comparison's border leaves nothing of its side"
                                     : "nothing of its side is in the region";
}

} // namespace preview
