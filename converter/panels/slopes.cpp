#include "converter/panels/all.h"
#include "converter/panels/parts.h"
#include "converter/panels/ramps.h"

#include <numeric>

namespace converter {
namespace {

plot::Figure slope_figure(ShownLooks looks, const char* title, const char* x_label,
                          std::vector<Ramp> (*ramps_of)(const ShownLook& look)) {
    plot::Figure out;
    out.title = title;
    out.x.label = x_label;
    out.y.label = "slope: output code values per input code value";
    out.y.range = {0, 1};
    for (std::size_t i = 0; i < looks.size(); ++i) {
        for (const Ramp& ramp : ramps_of(looks[i])) {
            plot::Line line =
                line_of(looks, i, channel_names[ramp.channel], series_of_channel[ramp.channel]);
            for (std::size_t k = 0; k + 1 < ramp.in.size(); ++k) {
                line.points.emplace_back(std::midpoint(ramp.in[k], ramp.in[k + 1]),
                                         (ramp.out[k + 1] - ramp.out[k]) /
                                             (ramp.in[k + 1] - ramp.in[k]));
            }
            out.lines.push_back(std::move(line));
        }
    }
    for (plot::Line& line : key_of(looks)) {
        out.lines.push_back(std::move(line));
    }
    return out;
}

std::vector<plot::Figure> slope_figures(ShownLooks looks) {
    return {slope_figure(looks, "Slope of the neutral axis", "input code value, R = G = B",
                         neutral_ramps),
            slope_figure(looks, "Slope of the channels",
                         "one channel in, the others at their lowest", channel_ramps)};
}

} // namespace

const Panel panel::slopes{
    .name = "slopes",
    .label = "Slopes",
    .help = "How steep those curves are, over each 512th of the domain: contrast above 1, "
            "clipping or crushing at 0, an order of tones turned round below 0.",
    .figures = slope_figures,
};

} // namespace converter
