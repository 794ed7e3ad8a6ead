// Ways to look at the finished picture other than as it is, as a table: its levels, what is clipped
// or outside the gamut, its channels.
#pragma once

#include "lutlib/named.h"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace preview {

/// What a colour of a view stands for.
struct LegendEntry {
    std::array<float, 3> color{}; ///< as codes
    std::string_view text;        ///< in characters of passes/glyphs.h
};

/// A part of the range of luma, from the one before up to `to`, and the colour that stands for it.
struct LevelBand {
    double to = 0;
    std::string_view text; ///< empty: the picture itself, grey
    std::array<float, 3> color{};
};

struct PictureView {
    std::string_view name;
    std::string_view label;
    /// The function of shaders/common/picture_views.glsl that shows it; empty: the picture itself.
    std::string_view shader;
    bool reads_before = false; ///< the picture before the looks too
    std::span<const LegendEntry> legend{};

    bool is_picture() const { return shader.empty(); }
};

/// The levels of `false-color`, in shares of the range of codes. The bands are those of ARRI's
/// cameras (ALEXA manuals), the middle ones moved to where sRGB has 18 % grey (0.461) and the stop
/// above it (0.636).
inline constexpr std::array<LevelBand, 9> level_bands{{
    {0.025, "BLACK", {0.42F, 0.10F, 0.62F}},
    {0.04, "NEARLY BLACK", {0.10F, 0.30F, 0.95F}},
    {0.44, "", {}},
    {0.48, "18 PERCENT GREY", {0.15F, 0.75F, 0.20F}},
    {0.615, "", {}},
    {0.655, "ONE STOP ABOVE", {0.98F, 0.60F, 0.70F}},
    {0.97, "", {}},
    {0.99, "NEARLY WHITE", {0.98F, 0.90F, 0.15F}},
    {1e30, "WHITE", {0.90F, 0.10F, 0.10F}},
}};

std::span<const PictureView> picture_views();
const PictureView* picture_view_named(std::string_view name);
/// The row's place in the table, by which shaders know it.
int index_of(const PictureView& row);

} // namespace preview
