#include "lutlib/plot/heat_map.h"

#include "lutlib/plot/axis.h"
#include "lutlib/plot/palette.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace plot {
namespace {

constexpr std::string_view letters =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz-_";
static_assert(letters.size() == heat_levels);

std::string fill_of(char letter) {
    const std::size_t level = letters.find(letter);
    return level == std::string_view::npos ? "none" : heat_color(level);
}

std::size_t level_of(double share) {
    return static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * (heat_levels - 1)));
}

std::string color_of(std::string_view three) {
    const auto code = [](char letter) {
        const std::size_t level = letters.find(letter);
        return level == std::string_view::npos
                   ? std::size_t{0}
                   : (255 * level + heat_levels / 2) / (heat_levels - 1);
    };
    return fmt::format("#{:02x}{:02x}{:02x}", code(three[0]), code(three[1]), code(three[2]));
}

} // namespace

char level_letter(std::size_t level) {
    return letters[std::min(level, heat_levels - 1)];
}

std::string level_letters() {
    return std::string(letters);
}

char error_letter(double error) {
    if (std::isnan(error)) {
        return no_level;
    }
    const double share =
        std::log(std::max(error, heat_low) / heat_low) / std::log(heat_high / heat_low);
    return letters[level_of(share)];
}

char share_letter(double share) {
    return letters[level_of(std::isnan(share) ? 0 : share)];
}

std::string svg(const HeatMap& map) {
    constexpr double side = 260, left = 30, top = 28, bottom = 30;
    const double w = side / map.columns, h = side / map.rows;
    std::string out = fmt::format(
        "<svg class=\"heat\" id=\"{}\" viewBox=\"0 0 {:g} {:g}\" role=\"img\" aria-label=\"{}\">\n"
        "<text class=\"title\" x=\"{:g}\" y=\"18\">{}</text><g class=\"cells\">\n",
        map.id, left + side + 6, top + side + bottom, escaped(map.title), left, escaped(map.title));
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const char letter = map.levels[static_cast<std::size_t>(row * map.columns + column)];
            out += fmt::format("<path fill=\"{}\" d=\"M{:.1f} {:.1f}h{:.1f}v{:.1f}h-{:.1f}z\"/>",
                               fill_of(letter), left + column * w, top + side - (row + 1) * h,
                               w + 0.3, h + 0.3, w + 0.3);
        }
    }
    out += "</g>\n";
    for (int i = map.lines_every; map.lines_every && i < map.columns; i += map.lines_every) {
        out += fmt::format("<path class=\"node\" d=\"M{:.1f} {:g}v{:g}M{:g} {:.1f}h{:g}\"/>",
                           left + i * w, top, side, left, top + i * h, side);
    }
    out +=
        fmt::format("<path class=\"frame\" d=\"M{0:g} {1:g}h{2:g}v{2:g}h-{2:g}z\"/>"
                    "<text class=\"name\" x=\"{3:g}\" y=\"{4:g}\" text-anchor=\"middle\">{5}</text>"
                    "<text class=\"name\" transform=\"translate(20 {6:g}) rotate(-90)\" "
                    "text-anchor=\"middle\">{7}</text>\n</svg>\n",
                    left, top, side, left + side / 2, top + side + 19, escaped(map.x_label),
                    top + side / 2, escaped(map.y_label));
    return out;
}

std::string svg(const Band& band) {
    constexpr double wide = 720, high = 26;
    const std::size_t columns = band.levels.size() / 3;
    const double w = wide / static_cast<double>(std::max(columns, std::size_t{1}));
    std::string out =
        fmt::format("<div class=\"band\"><span>{}</span><svg id=\"{}\" viewBox=\"0 0 {:g} {:g}\" "
                    "preserveAspectRatio=\"none\"><g class=\"cells\">\n",
                    escaped(band.label), band.id, wide, high);
    for (std::size_t i = 0; i < columns; ++i) {
        out += fmt::format("<path fill=\"{}\" d=\"M{:.1f} 0h{:.1f}v{:g}h-{:.1f}z\"/>",
                           color_of(std::string_view(band.levels).substr(3 * i, 3)),
                           static_cast<double>(i) * w, w + 0.4, high, w + 0.4);
    }
    return out + "</g></svg></div>\n";
}

std::string heat_legend(const std::string& metric) {
    constexpr double wide = 320, left = 18;
    std::string out = fmt::format("<svg class=\"scale\" viewBox=\"0 0 {:g} 44\" role=\"img\" "
                                  "aria-label=\"scale\">\n",
                                  wide + 90);
    for (std::size_t i = 0; i < heat_levels; ++i) {
        const double w = wide / heat_levels;
        out += fmt::format("<path fill=\"{}\" d=\"M{:.1f} 4h{:.1f}v16h-{:.1f}z\"/>", heat_color(i),
                           left + static_cast<double>(i) * w, w + 0.3, w + 0.3);
    }
    for (const double value : {0.01, 0.1, 1.0, 10.0}) {
        const double at = std::log(value / heat_low) / std::log(heat_high / heat_low);
        out += fmt::format("<text class=\"name\" x=\"{:.1f}\" y=\"36\" text-anchor=\"middle\">{:g}"
                           "</text>",
                           left + at * wide, value);
    }
    return out + fmt::format("<text class=\"name\" x=\"{:g}\" y=\"17\">{}</text></svg>\n",
                             left + wide + 8, escaped(metric));
}

} // namespace plot
