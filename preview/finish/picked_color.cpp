#include "preview/finish/picked_color.h"

#include "lutlib/color/luma.h"
#include "lutlib/color/transfer.h"

#include <fmt/format.h>

#include <algorithm>

namespace preview {

ColorFigures figures_of(lutlib::RgbD color, double white) {
    const lutlib::RgbD held = lutlib::saturate(color);
    ColorFigures out;
    out.codes = codes_of(held);
    for (std::size_t c = 0; c < 3; ++c) {
        out.linear[c] = lutlib::srgb_decode(held[c]);
    }
    // ITU-R BT.709's weights, which are sRGB's.
    out.luminance = white * (0.2126 * out.linear.r + 0.7152 * out.linear.g + 0.0722 * out.linear.b);
    out.lab = lutlib::lab_from_srgb(held);
    return out;
}

void pick(std::vector<PickedColor>& picked, const PickedColor& color) {
    picked.insert(picked.begin(), color);
    picked.resize(std::min(picked.size(), most_picked_colors));
}

std::string codes_text(const ColorFigures& figures) {
    return fmt::format("{} {} {}", figures.codes.r, figures.codes.g, figures.codes.b);
}

std::string linear_text(const ColorFigures& figures) {
    return fmt::format("{:.4f} {:.4f} {:.4f}", figures.linear.r, figures.linear.g,
                       figures.linear.b);
}

std::string luminance_text(const ColorFigures& figures) {
    return fmt::format("{:.4g} cd/m2", figures.luminance);
}

std::string lab_text(const ColorFigures& figures) {
    return fmt::format("L* {:.1f} a* {:.1f} b* {:.1f}", figures.lab.L, figures.lab.a,
                       figures.lab.b);
}

} // namespace preview
