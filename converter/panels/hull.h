// Gamut hulls: the outline of all colours that a look makes of its domain.
#pragma once

#include "converter/panels/panel.h"

#include <functional>
#include <utility>
#include <vector>

namespace converter {

using PlanePoint = std::pair<double, double>;

/// The corners of the smallest convex outline around points, counter-clockwise and without those
/// on an edge. Points that are not finite do not count.
std::vector<PlanePoint> convex_hull(std::vector<PlanePoint> points);
double area_of(const std::vector<PlanePoint>& outline);

/// Light that a domain's lattice of 25 nodes a side stands for, before and after a look.
std::vector<lutlib::RgbD> light_before(const ShownLook& look);
std::vector<lutlib::RgbD> light_after(const ShownLook& look);

/// A place in the plane of linear Rec.709 light; not finite where it has none.
using PlaceOf = std::function<PlanePoint(lutlib::RgbD)>;

/// Hulls before (thin) and after each look; the legend says their areas in those of `whole`, by
/// its name.
plot::Figure hull_figure(ShownLooks looks, const PlaceOf& place,
                         const std::vector<PlanePoint>& whole, const std::string& whole_name);

/// An outline as a closed line.
plot::Line closed(plot::Line line, const std::vector<PlanePoint>& outline);

} // namespace converter
