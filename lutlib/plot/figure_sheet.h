// Figures beside and below each other, as one drawing.
#pragma once

#include "lutlib/plot/figure.h"

#include <span>
#include <string>
#include <vector>

namespace plot {

/// Under headlines, a line each. As many figures stand side by side as have room in `width` dots,
/// all of one width; one that is wide has a row of its own. Figures keep their order.
Drawing figure_sheet(std::span<const std::string> headlines, std::span<const Figure> figures,
                     double width);

/// How wide a sheet is whose picture is to have so many pixels: a whole number of pixels a dot
/// where they are enough for it.
double sheet_dots(int pixels, std::span<const Figure> figures);

} // namespace plot
