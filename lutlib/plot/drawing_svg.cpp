#include "lutlib/plot/axis.h"
#include "lutlib/plot/dot_font.h"
#include "lutlib/plot/drawing.h"
#include "lutlib/plot/palette.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

namespace plot {
namespace {

/// Of letters whose capitals are as high as the font's of dots, which end so far below their top.
constexpr double letter_size = 9.6, baseline = 7;

std::string path_of(const std::vector<Point>& points) {
    std::string out;
    bool is_drawn = false;
    for (const Point& p : points) {
        const bool is_place = std::isfinite(p.x) && std::isfinite(p.y);
        if (is_place) {
            out += fmt::format("{}{:.2f} {:.2f}", is_drawn ? "L" : "M", p.x, p.y);
        }
        is_drawn = is_place;
    }
    return out;
}

// Of an element whose attributes have been written.
std::string end_of(const char* element, const std::string& label) {
    return label.empty() ? "/>" : fmt::format("><title>{}</title></{}>", escaped(label), element);
}

struct SvgShape {
    std::string operator()(const Stroke& s) const {
        const std::string path = path_of(s.points);
        return path.empty() ? path
                            : fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\" "
                                          "stroke-linejoin=\"round\"{} d=\"{}\"{}\n",
                                          css_color(s.color), s.width,
                                          s.dashed ? " stroke-dasharray=\"4 2.5\"" : "", path,
                                          end_of("path", s.label));
    }
    std::string operator()(const Disc& d) const {
        return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:g}\" fill=\"{}\"/>\n",
                           d.center.x, d.center.y, d.radius, css_color(d.color));
    }
    std::string operator()(const Box& b) const {
        return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
                           "fill=\"{}\" shape-rendering=\"crispEdges\"{}\n",
                           b.corner.x, b.corner.y, b.opposite.x - b.corner.x,
                           b.opposite.y - b.corner.y, css_color(b.color), end_of("rect", b.label));
    }
    std::string operator()(const Words& w) const {
        constexpr std::array<const char*, 3> anchors{"start", "middle", "end"};
        // Beside their class, which a page may style, for files that stand alone.
        return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\" "
                           "style=\"font:{}{:g}px system-ui,sans-serif;fill:{}\">{}</text>\n",
                           w.at.x, w.at.y + baseline, anchors[static_cast<std::size_t>(w.anchor)],
                           w.bold ? "600 " : "", letter_size, css_color(w.color),
                           escaped(text_cut_in_the_middle(w.text, w.most)));
    }
};

} // namespace

std::string svg(const Drawing& drawing, int width) {
    const std::string alone =
        width > 0 ? fmt::format(" xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\"",
                                width, raster_height(drawing, width))
                  : "";
    std::string out =
        fmt::format("<svg{} viewBox=\"0 0 {:g} {:g}\" role=\"img\" aria-label=\"{}\">\n", alone,
                    drawing.width, drawing.height, escaped(drawing.label));
    if (width > 0) {
        out += "<metadata>lutconv</metadata>\n";
        out += fmt::format("<rect width=\"{:g}\" height=\"{:g}\" fill=\"{}\"/>\n", drawing.width,
                           drawing.height, css_color(drawing_ground));
    }
    for (const Shape& shape : drawing.shapes) {
        out += std::visit(SvgShape{}, shape);
    }
    return out + "</svg>\n";
}

} // namespace plot
