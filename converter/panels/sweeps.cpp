#include "converter/panels/sweeps.h"

#include "converter/panels/parts.h"

#include <algorithm>
#include <cmath>

namespace converter {
namespace {

constexpr double middle_grey = 0.18, lowest_stop = -8, highest_stop = 16;
constexpr int steps_a_stop = 8;

bool holds(const lutlib::Domain& domain, lutlib::RgbD codes) {
    bool out = true;
    for (std::size_t c = 0; c < 3; ++c) {
        // Codes of light come from a float's domain, whose ends are not met to the last digit.
        const double room = 1e-6 * (domain.max[c] - domain.min[c]);
        out = out && codes[c] >= domain.min[c] - room && codes[c] <= domain.max[c] + room;
    }
    return out;
}

plot::Line sweep_line(const Sweep& sweep, const std::vector<lutlib::RgbD>& colors,
                      const std::function<double(lutlib::RgbD, lutlib::RgbD)>& value,
                      plot::Line line) {
    for (std::size_t i = 0; i < sweep.stops.size(); ++i) {
        line.points.emplace_back(sweep.stops[i], value(colors[i], sweep.before[i]));
    }
    return line;
}

} // namespace

std::vector<Sweep> sweeps_of(const ShownLook& look) {
    const SeenLight input(look.input), output(look.output);
    const lutlib::Primaries& primaries = look.input.primaries();
    const lutlib::Matrix3 to_rec709 = rgb_to_rgb(primaries, lutlib::rec709);
    std::vector<Sweep> out;
    for (std::size_t h = 0; h < std::size(hue_rows); ++h) {
        Sweep sweep{h, {}, {}, {}};
        std::vector<lutlib::RgbD> codes;
        const lutlib::RgbD half = hue_rows[h].rgb * 0.5 + lutlib::RgbD{0.5, 0.5, 0.5};
        const lutlib::RgbD light = to_rec709 * half;
        const lutlib::RgbD base = light * (middle_grey / xyz_of_light(light).g);
        for (int i = 0; i <= steps_a_stop * (highest_stop - lowest_stop); ++i) {
            const double stop = lowest_stop + i / double{steps_a_stop};
            const lutlib::RgbD before = base * std::exp2(stop);
            const lutlib::RgbD code = input.codes(before);
            // A curve that ends clips; what it clips is no colour of this luminance.
            const double back = xyz_of_light(input.of(code)).g / xyz_of_light(before).g;
            if (holds(look.domain, code) && std::abs(back - 1) < 1e-3) {
                sweep.stops.push_back(stop);
                sweep.before.push_back(before);
                codes.push_back(code);
            }
        }
        for (const lutlib::RgbD& image : images_of(look, std::move(codes))) {
            sweep.after.push_back(output.of(image));
        }
        out.push_back(std::move(sweep));
    }
    return out;
}

plot::Figure sweep_figure(ShownLooks looks,
                          const std::function<double(lutlib::RgbD, lutlib::RgbD)>& value) {
    plot::Figure out;
    out.x.label = "input luminance in stops about 18 % grey";
    for (const ShownLook* look : befores(looks)) {
        for (const Sweep& sweep : sweeps_of(*look)) {
            const bool is_first = sweep.hue == 0;
            out.lines.push_back(sweep_line(sweep, sweep.before, value,
                                           thin_line(is_first ? before_name(looks, *look) : "")));
        }
    }
    for (std::size_t i = 0; i < looks.size(); ++i) {
        for (const Sweep& sweep : sweeps_of(looks[i])) {
            const HueRow& row = hue_rows[sweep.hue];
            out.lines.push_back(
                sweep_line(sweep, sweep.after, value, line_of(looks, i, row.name, row.series)));
        }
    }
    for (plot::Line& line : key_of(looks)) {
        out.lines.push_back(std::move(line));
    }
    const bool is_empty = std::all_of(out.lines.begin(), out.lines.end(),
                                      [](const plot::Line& l) { return l.points.empty(); });
    if (is_empty) {
        out.notes.push_back({0.5, 0.5, "the domain holds none of these colours"});
        out.x.range = out.y.range = {0, 1};
    }
    return out;
}

} // namespace converter
