// Colours of plots.
#pragma once

#include "lutlib/plot/raster.h"

#include <array>
#include <cstddef>
#include <string>

namespace plot {

/// Okabe and Ito's palette, which the colour-blind can tell apart ("Color Universal Design", 2008).
inline constexpr std::array<const char*, 8> series_colors{
    "#999999", "#D55E00", "#0072B2", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#222222"};

/// The colour of a series; `pale`: half way to white.
Rgb8 series_color(std::size_t series, bool pale = false);
/// "#rrggbb".
std::string css_color(Rgb8 color);

inline constexpr std::size_t heat_levels = 64;
/// From dark blue through grey to yellow, of evenly rising lightness, for the colour-blind as well
/// (the ends and the middle of cividis: Nuñez, Anderton and Renslow, PLOS ONE 13(7), 2018).
/// "#rrggbb".
std::string heat_color(std::size_t level);

} // namespace plot
