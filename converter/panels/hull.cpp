#include "converter/panels/hull.h"

#include "converter/panels/parts.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace converter {
namespace {

constexpr int hull_nodes = 25;

// Twice the area of a triangle: above 0 where the way turns left at b.
double turn(PlanePoint a, PlanePoint b, PlanePoint c) {
    return (b.first - a.first) * (c.second - a.second) -
           (b.second - a.second) * (c.first - a.first);
}

std::vector<PlanePoint> hull_of(const std::vector<lutlib::RgbD>& light, const PlaceOf& place) {
    std::vector<PlanePoint> points;
    for (const lutlib::RgbD& color : light) {
        points.push_back(place(color));
    }
    return convex_hull(std::move(points));
}

std::vector<lutlib::RgbD> lattice_of(const lutlib::Domain& domain) {
    std::vector<lutlib::RgbD> out;
    for (const lutlib::Rgb& node : lutlib::identity_cube(hull_nodes, domain).nodes) {
        out.push_back(to_double(node));
    }
    return out;
}

std::vector<lutlib::RgbD> in_light(std::vector<lutlib::RgbD> codes,
                                   const lutlib::Encoding& encoding) {
    const SeenLight seen(encoding);
    for (lutlib::RgbD& c : codes) {
        c = seen.of(c);
    }
    return codes;
}

} // namespace

// Andrew's monotone chain (Information Processing Letters 9(5), 1979): the lower half from the
// left, then the upper half back.
std::vector<PlanePoint> convex_hull(std::vector<PlanePoint> points) {
    std::erase_if(points,
                  [](PlanePoint p) { return !std::isfinite(p.first) || !std::isfinite(p.second); });
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) {
        return points;
    }
    std::vector<PlanePoint> out;
    const auto add = [&](PlanePoint p, std::size_t kept) {
        while (out.size() >= kept + 2 && turn(out[out.size() - 2], out.back(), p) <= 0) {
            out.pop_back();
        }
        out.push_back(p);
    };
    for (const PlanePoint& p : points) {
        add(p, 0);
    }
    const std::size_t lower = out.size() - 1;
    for (auto p = points.rbegin() + 1; p != points.rend(); ++p) {
        add(*p, lower);
    }
    out.pop_back();
    return out;
}

double area_of(const std::vector<PlanePoint>& outline) {
    double out = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PlanePoint a = outline[i], b = outline[(i + 1) % outline.size()];
        out += (a.first * b.second - b.first * a.second) / 2;
    }
    return out;
}

std::vector<lutlib::RgbD> light_before(const ShownLook& look) {
    return in_light(lattice_of(look.domain), look.input);
}

std::vector<lutlib::RgbD> light_after(const ShownLook& look) {
    return in_light(images_of(look, lattice_of(look.domain)), look.output);
}

plot::Line closed(plot::Line line, const std::vector<PlanePoint>& outline) {
    line.points = outline;
    if (!outline.empty()) {
        line.points.push_back(outline.front());
    }
    return line;
}

plot::Figure hull_figure(ShownLooks looks, const PlaceOf& place,
                         const std::vector<PlanePoint>& whole, const std::string& whole_name) {
    plot::Figure out;
    out.same_units = true;
    constexpr double nothing = 1e-9; // what rounding makes of a line
    const auto add = [&](plot::Line line, const std::vector<lutlib::RgbD>& light) {
        const std::vector<PlanePoint> outline = hull_of(light, place);
        const double share = area_of(outline) / area_of(whole);
        line.name += fmt::format(", {:.3g} x {}", share > nothing ? share : 0, whole_name);
        out.lines.push_back(closed(std::move(line), outline));
    };
    for (const ShownLook* look : befores(looks)) {
        add(thin_line(before_name(looks, *look)), light_before(*look));
    }
    for (std::size_t i = 0; i < looks.size(); ++i) {
        add(line_of(looks, i), light_after(looks[i]));
    }
    return out;
}

} // namespace converter
