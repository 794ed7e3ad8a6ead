#include "converter/panels/all.h"
#include "converter/panels/parts.h"
#include "converter/panels/ramps.h"

namespace converter {
namespace {

using RampsOf = std::vector<Ramp> (*)(const ShownLook& look);

plot::Figure curve_figure(ShownLooks looks, const char* title, const char* x_label,
                          RampsOf ramps_of) {
    plot::Figure out;
    out.title = title;
    out.x.label = x_label;
    out.y.label = "output code value";
    plot::Line same = thin_line("no change");
    plot::Extent inputs;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        for (const Ramp& ramp : ramps_of(looks[i])) {
            plot::Line line =
                line_of(looks, i, channel_names[ramp.channel], series_of_channel[ramp.channel]);
            for (std::size_t k = 0; k < ramp.in.size(); ++k) {
                line.points.emplace_back(ramp.in[k], ramp.out[k]);
            }
            inputs.add(ramp.in);
            out.lines.push_back(std::move(line));
        }
    }
    for (plot::Line& line : key_of(looks)) {
        out.lines.push_back(std::move(line));
    }
    same.points = {{inputs.low, inputs.low}, {inputs.high, inputs.high}};
    out.lines.insert(out.lines.begin(), std::move(same));
    return out;
}

std::vector<plot::Figure> curve_figures(ShownLooks looks) {
    return {curve_figure(looks, "Curves of the neutral axis", "input code value, R = G = B",
                         neutral_ramps),
            curve_figure(looks, "Curves of the channels",
                         "one channel in, the others at their lowest", channel_ramps)};
}

} // namespace

const Panel panel::curves{
    .name = "curves",
    .label = "Curves",
    .help = "What becomes of the neutral axis, where red, green and blue are equal, and of each "
            "channel alone while the others are at their lowest: code values out against code "
            "values in.",
    .figures = curve_figures,
};

} // namespace converter
