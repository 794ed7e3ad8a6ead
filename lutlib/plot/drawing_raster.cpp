#include "lutlib/plot/dot_font.h"
#include "lutlib/plot/drawing.h"
#include "lutlib/plot/raster_shapes.h"

#include <algorithm>
#include <cmath>

namespace plot {
namespace {

struct RasterShape {
    Raster& out;
    double scale; ///< pixels a dot

    int pixel(double place) const { return static_cast<int>(std::lround(place * scale)); }

    void operator()(const Stroke& s) const {
        std::vector<Point> points = s.points;
        for (Point& p : points) {
            p = {p.x * scale, p.y * scale};
        }
        const double width = std::max(s.width * scale, 1.0);
        for (const std::vector<Point>& piece :
             s.dashed ? dashes_of(points, 4 * scale, 2.5 * scale) : pieces_of(points)) {
            draw_line(out, piece, width, s.color);
        }
    }
    void operator()(const Disc& d) const {
        draw_disc(out, {d.center.x * scale, d.center.y * scale}, d.radius * scale, d.color);
    }
    void operator()(const Box& b) const {
        const int x = pixel(b.corner.x), y = pixel(b.corner.y);
        out.fill(x, y, pixel(b.opposite.x) - x, pixel(b.opposite.y) - y, b.color);
    }
    void operator()(const Words& w) const {
        const int dot = std::max(1, static_cast<int>(scale));
        const std::string glyphs = glyphs_of(text_cut_in_the_middle(w.text, w.most));
        const int length = (static_cast<int>(glyphs.size()) * glyph_step - 1) * dot;
        const int before = w.anchor == Anchor::start    ? 0
                           : w.anchor == Anchor::middle ? length / 2
                                                        : length;
        out.write(glyphs, pixel(w.at.x) - before, pixel(w.at.y), dot, w.color);
    }
};

} // namespace

int raster_height(const Drawing& drawing, int width) {
    return std::max(1, static_cast<int>(std::lround(drawing.height * width / drawing.width)));
}

Raster raster(const Drawing& drawing, int width) {
    Raster out(width, raster_height(drawing, width), drawing_ground);
    const RasterShape draw{out, width / drawing.width};
    for (const Shape& shape : drawing.shapes) {
        std::visit(draw, shape);
    }
    return out;
}

} // namespace plot
