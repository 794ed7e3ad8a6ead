#include "converter/heat_png.h"

#include "converter/paint_picture.h"
#include "lutlib/plot/palette.h"

#include <algorithm>
#include <charconv>

namespace converter {

std::string heat_png(const lutlib::OnPicture& on) {
    constexpr double most = 10;
    lutlib::Picture out{on.size.width, on.size.height, {}};
    std::vector<lutlib::Rgb> colors;
    for (std::size_t level = 0; level < plot::heat_levels; ++level) {
        const std::string text = plot::heat_color(level);
        lutlib::Rgb color;
        for (std::size_t c = 0; c < 3; ++c) {
            int code = 0;
            std::from_chars(&text[1 + 2 * c], &text[3 + 2 * c], code, 16);
            color[c] = static_cast<float>(code) / 255;
        }
        colors.push_back(color);
    }
    for (const float error : on.map) {
        const double level = static_cast<double>(error) / most * (plot::heat_levels - 1);
        out.pixels.push_back(error < 0 ? lutlib::Rgb{0.5F, 0.5F, 0.5F}
                                       : colors[static_cast<std::size_t>(std::min(
                                             level, static_cast<double>(plot::heat_levels - 1)))]);
    }
    return png_of(out, "dE2000 of 0 to 10 between the look and the graded picture");
}

} // namespace converter
