#include "converter/panels/all.h"
#include "converter/panels/parts.h"
#include "lutlib/plot/dot_font.h"

#include <fmt/core.h>

#include <cmath>

namespace converter {
namespace {

constexpr int slice_cells = 24;
constexpr double next_slice = 1.12;

// The middles of cells over red and green of a domain, at a share of its blue.
std::vector<lutlib::RgbD> slice_codes(const lutlib::Domain& domain, double blue) {
    std::vector<lutlib::RgbD> out;
    for (int g = 0; g < slice_cells; ++g) {
        for (int r = 0; r < slice_cells; ++r) {
            const double shares[3]{(r + 0.5) / slice_cells, (g + 0.5) / slice_cells, blue};
            lutlib::RgbD code;
            for (std::size_t c = 0; c < 3; ++c) {
                code[c] = std::lerp(to_double(domain.min)[c], to_double(domain.max)[c], shares[c]);
            }
            out.push_back(code);
        }
    }
    return out;
}

void add_slice(plot::Figure& figure, const std::string& name, std::vector<lutlib::RgbD> codes,
               const lutlib::Encoding& encoding, const lutlib::Domain& domain) {
    const double left = next_slice * static_cast<double>(figure.cells.size());
    const SeenLight seen(encoding);
    for (lutlib::RgbD& c : codes) {
        c = srgb_of_light(seen.of(c));
    }
    figure.cells.push_back({name, left, left + 1, 0, 1, slice_cells, slice_cells, codes});
    figure.notes.push_back({left + 0.5, 1.07, plot::text_cut_in_the_middle(name, 14)});
    figure.x.ticks.push_back({left, fmt::format("{:.3g}", domain.min.r)});
    figure.x.ticks.push_back({left + 1, fmt::format("{:.3g}", domain.max.r)});
}

plot::Figure slice_figure(ShownLooks looks, double blue) {
    plot::Figure out;
    const lutlib::Domain& first = looks.front().domain;
    out.title = fmt::format("Slice at blue {:.3g}", std::lerp(first.min.b, first.max.b, blue));
    out.x.label = "red";
    out.y.label = "green";
    out.same_units = true;
    out.y.range = {0, 1.12};
    out.y.ticks = {{0, fmt::format("{:.3g}", first.min.g)},
                   {1, fmt::format("{:.3g}", first.max.g)}};
    for (const ShownLook* look : befores(looks)) {
        add_slice(out, before_name(looks, *look), slice_codes(look->domain, blue), look->input,
                  look->domain);
    }
    for (const ShownLook& look : looks) {
        add_slice(out, look.name, images_of(look, slice_codes(look.domain, blue)), look.output,
                  look.domain);
    }
    return out;
}

std::vector<plot::Figure> slice_figures(ShownLooks looks) {
    return {slice_figure(looks, 0), slice_figure(looks, 0.5), slice_figure(looks, 1)};
}

} // namespace

const Panel panel::slices{
    .name = "slices",
    .label = "Slices",
    .help = "The domain's colours at its lowest, middle and highest blue, before and after, as an "
            "sRGB display shows them.",
    .figures = slice_figures,
};

} // namespace converter
