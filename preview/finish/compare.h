// How two looks are shown together, as a table.
#pragma once

#include "lutlib/named.h"
#include "preview/gpu/size.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace preview {

struct Compare {
    std::string_view name;
    std::string_view label;
    std::string_view shader; ///< the function of shaders/common/compare.glsl that shows it
    bool shows_a, shows_b;
    bool shows_one = false; ///< a texel shows A or B, on either side of a line or box (wipe.h)
};

inline constexpr std::array<Compare, 6> compares{{
    {.name = "a", .label = "side A alone", .shader = "show_a", .shows_a = true, .shows_b = false},
    {.name = "b", .label = "side B alone", .shader = "show_b", .shows_a = false, .shows_b = true},
    {.name = "split",
     .label = "A and B on either side of a line that can be moved and turned",
     .shader = "show_split",
     .shows_a = true,
     .shows_b = true,
     .shows_one = true},
    {.name = "box",
     .label = "A inside a box and B around it",
     .shader = "show_split",
     .shows_a = true,
     .shows_b = true,
     .shows_one = true},
    {.name = "side",
     .label = "A and B side by side, each half as wide as the output",
     .shader = "show_side",
     .shows_a = true,
     .shows_b = true},
    {.name = "diff",
     .label = "their difference in dE2000 as a heat map with its scale",
     .shader = "show_difference",
     .shows_a = true,
     .shows_b = true},
}};
inline constexpr const Compare& compare_a = lutlib::row_named(compares, "a");
inline constexpr const Compare& compare_b = lutlib::row_named(compares, "b");
inline constexpr const Compare& compare_split = lutlib::row_named(compares, "split");
inline constexpr const Compare& compare_box = lutlib::row_named(compares, "box");
inline constexpr const Compare& compare_side = lutlib::row_named(compares, "side");
inline constexpr const Compare& compare_difference = lutlib::row_named(compares, "diff");

const Compare* compare_named(std::string_view name);
/// The row's place in the table, by which shaders know it.
int index_of(const Compare& row);

/// The size at which a scene is rendered so that its finished picture is `output` wide and high.
Size picture_size(Size output, const Compare& compare);

/// How the finishing pass counts differences: those from n / per_unit on in bin n.
struct DifferenceBins {
    static constexpr std::uint32_t count = 4096;
    static constexpr double per_unit = 40; ///< of dE2000
};

/// The differences of all texels of a picture, in dE2000.
struct DifferenceFigures {
    double max = 0, p99 = 0, p95 = 0, mean = 0;
    friend bool operator==(const DifferenceFigures&, const DifferenceFigures&) = default;
};

/// From what the finishing pass counted over a picture of so many texels. The maximum is exact,
/// the others to 0.025; differences above 102 count as 102.
DifferenceFigures difference_figures(std::span<const std::uint32_t> counted, std::uint64_t texels);

/// While nothing is measured.
inline constexpr float usual_heat_scale = 8;
/// dE2000 at the end of a heat map that is not told: the 99th percentile, up to the next multiple
/// of 4 within 4..96, which its scale can show.
float heat_scale_for(const DifferenceFigures& figures);

} // namespace preview
