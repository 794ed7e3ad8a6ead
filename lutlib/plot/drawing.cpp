#include "lutlib/plot/drawing.h"

namespace plot {
namespace {

struct Moved {
    Point by;

    Point operator()(Point p) const { return {p.x + by.x, p.y + by.y}; }
    void operator()(Stroke& s) const {
        for (Point& p : s.points) {
            p = (*this)(p);
        }
    }
    void operator()(Disc& d) const { d.center = (*this)(d.center); }
    void operator()(Box& b) const {
        b.corner = (*this)(b.corner);
        b.opposite = (*this)(b.opposite);
    }
    void operator()(Words& w) const { w.at = (*this)(w.at); }
};

} // namespace

void Drawing::add(const Drawing& part, Point at) {
    for (Shape shape : part.shapes) {
        std::visit(Moved{at}, shape);
        shapes.push_back(std::move(shape));
    }
}

} // namespace plot
