#include "converter/panels/all.h"
#include "converter/panels/parts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace converter {
namespace {

constexpr int cube_nodes = 11, edge_places = 25;

// Seen from the side with black below and white above: the neutral axis is upright but for a tilt
// towards the eye, and no two of the corners hide each other.
struct Seen {
    double x, y, depth;
};
Seen seen(lutlib::RgbD c) {
    constexpr double turned = 0.5, tilt = 0.35;
    const double up = (c.r + c.g + c.b) / std::sqrt(3.0);
    const double u = (2 * c.r - c.g - c.b) / std::sqrt(6.0), v = (c.g - c.b) / std::sqrt(2.0);
    const double x = -(u * std::sin(turned) - v * std::cos(turned));
    const double towards = u * std::cos(turned) + v * std::sin(turned);
    return {x, up * std::cos(tilt) - towards * std::sin(tilt),
            towards * std::cos(tilt) + up * std::sin(tilt)};
}

plot::Line through(plot::Line line, const std::vector<lutlib::RgbD>& colors) {
    for (const lutlib::RgbD& c : colors) {
        const Seen place = seen(c);
        line.points.emplace_back(place.x, place.y);
    }
    return line;
}

// The twelve edges, each from a lower corner to a higher one.
std::vector<std::vector<lutlib::RgbD>> edges_of(const lutlib::Domain& domain) {
    std::vector<std::vector<lutlib::RgbD>> out;
    for (std::size_t along = 0; along < 3; ++along) {
        for (unsigned corner = 0; corner < 4; ++corner) {
            lutlib::RgbD from = to_double(domain.min);
            const std::size_t other = (along + 1) % 3, third = (along + 2) % 3;
            from[other] = corner & 1U ? domain.max[other] : domain.min[other];
            from[third] = corner & 2U ? domain.max[third] : domain.min[third];
            std::vector<lutlib::RgbD> edge(edge_places, from);
            const std::vector<double> values =
                evenly(domain.min[along], domain.max[along], edge_places);
            for (std::size_t i = 0; i < values.size(); ++i) {
                edge[i][along] = values[i];
            }
            out.push_back(std::move(edge));
        }
    }
    return out;
}

plot::Dots nodes_of(const ShownLook& look) {
    std::vector<lutlib::RgbD> codes;
    for (const lutlib::Rgb& node : lutlib::identity_cube(cube_nodes, look.domain).nodes) {
        codes.push_back(to_double(node));
    }
    codes = images_of(look, std::move(codes));
    std::erase_if(codes, [](lutlib::RgbD c) { return !std::isfinite(largest_magnitude(c)); });
    std::stable_sort(codes.begin(), codes.end(),
                     [](lutlib::RgbD a, lutlib::RgbD b) { return seen(a).depth < seen(b).depth; });
    const SeenLight light(look.output);
    plot::Dots out{look.name, {}};
    for (const lutlib::RgbD& c : codes) {
        const Seen place = seen(c);
        out.dots.push_back({place.x, place.y, srgb_of_light(light.of(c))});
    }
    return out;
}

plot::Figure cube_figure(ShownLooks looks, std::size_t i) {
    const ShownLook& look = looks[i];
    plot::Figure out;
    out.title = "Cube: " + look.name;
    out.y.label = "nodes among codes; thin: edges before";
    out.has_axes = false;
    out.same_units = true;
    for (const std::vector<lutlib::RgbD>& edge : edges_of(look.domain)) {
        out.lines.push_back(through(thin_line(""), edge));
    }
    for (const std::vector<lutlib::RgbD>& edge : edges_of(look.domain)) {
        plot::Line line = line_of(looks, i);
        line.name.clear();
        out.lines.push_back(through(std::move(line), images_of(look, edge)));
    }
    out.dots = {nodes_of(look)};
    const lutlib::RgbD low = to_double(look.domain.min), high = to_double(look.domain.max);
    for (const HueRow& row : hue_rows) {
        const lutlib::RgbD corner{row.rgb.r > 0 ? high.r : low.r, row.rgb.g > 0 ? high.g : low.g,
                                  row.rgb.b > 0 ? high.b : low.b};
        const Seen place = seen(low + (corner - low) * 1.15);
        out.notes.push_back({place.x, place.y, std::string(1, row.name[0] - 'a' + 'A')});
    }
    return out;
}

std::vector<plot::Figure> cube_figures(ShownLooks looks) {
    std::vector<plot::Figure> out;
    plot::Extent x, y;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        out.push_back(cube_figure(looks, i));
        for (const plot::Line& line : out.back().lines) {
            for (const auto& [px, py] : line.points) {
                x.add(px);
                y.add(py);
            }
        }
        for (const plot::Dot& dot : out.back().dots.front().dots) {
            x.add(dot.x);
            y.add(dot.y);
        }
    }
    for (plot::Figure& figure : out) {
        figure.x.range = x;
        figure.y.range = y;
    }
    return out;
}

} // namespace

const Panel panel::cube{
    .name = "cube",
    .label = "Cube",
    .help = "Where the nodes of a lattice over the domain (11 a side) go, in the codes of the "
            "output and its colours, with the images of the twelve edges; the neutral axis stands "
            "upright, black below.",
    .figures = cube_figures,
};

} // namespace converter
