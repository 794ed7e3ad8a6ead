// Which texels of a finished picture the scopes count: those of one side of its comparison, those
// of a region, or all. Plain: no GPU.
#pragma once

#include "lutlib/named.h"
#include "preview/finish/wipe.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace preview {

/// Which part of the shown picture a scope looks at.
struct ScopeSide {
    std::string_view name;
    std::string_view label;
};
inline constexpr std::array<ScopeSide, 3> scope_sides{{
    {"shown", "all that is shown"},
    {"a", "what is shown of side A"},
    {"b", "what is shown of side B"},
}};
inline constexpr const ScopeSide& scope_side_shown = lutlib::row_named(scope_sides, "shown");

/// A part of the picture of one side, in shares of its width and height.
struct ScopeRegion {
    float x = 0, y = 0, width = 1, height = 1;
    friend bool operator==(const ScopeRegion&, const ScopeRegion&) = default;
};

/// Which texels of a rectangle are counted, by the border of a comparison (wipe.h).
enum class ScopePart : std::uint32_t { all, before_line, behind_line, in_box, around_box };

/// The texels that a scope counts.
struct ScopeArea {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    std::uint32_t copies = 1; ///< the rectangle in each of so many pictures side by side, up to two
    std::uint32_t stride = 0; ///< columns from one of them to the next
    ScopePart part = ScopePart::all;
    WipeShape border{};
    float reach = 0; ///< what is this near the border is neither side's

    std::uint32_t columns() const { return width * copies; }
    bool is_empty() const { return width == 0 || height == 0; }
    friend bool operator==(const ScopeArea&, const ScopeArea&) = default;
};

/// Whether this texel, which lies in the rectangle, is counted: twin of
/// shaders/common/scope_area.glsl.
bool is_counted(const ScopeArea& area, std::uint32_t x, std::uint32_t y);

/// The region as whole texels of a picture of that size, at least one.
ScopeArea texels_of(const ScopeRegion& region, Size picture);

/// The side's texels in the region, of a finished picture of that size, without the border; none
/// where nothing of the side is shown there, or where a heat map is.
ScopeArea scope_area(const ScopeSide& side, const Compare& compare, const Wipe& wipe,
                     const ScopeRegion& region, Size output);

/// Why scope_area() has no texel; empty where it has some.
std::string_view no_scope_because(const ScopeArea& area, const ScopeSide& side,
                                  const Compare& compare, const ScopeRegion& region);

} // namespace preview
