// Editing the knots of a curve parameter: what part of it is shown, and adding, moving and deleting
// knots so that the rest of the curve stays where it is.
#pragma once

#include "lutlib/ops/op.h"

#include <optional>

namespace preview::editor {

struct CurveView {
    double x_min = 0, x_max = 1, y_min = 0, y_max = 1;
};

/// The part of the parameter's axes that an editor shows: 0..1 where the axes are wider and the
/// neutral curve is the diagonal, else the neutral value in the middle; always with every knot.
CurveView view_of(const lutlib::Parameter& parameter, const lutlib::Knots& knots);

/// Adds a knot within the parameter's ranges and returns its index. A neutral curve first gets
/// neutral knots, at its ends or 60 degrees to both sides, so that it changes about the new knot
/// alone.
std::size_t add_knot(const lutlib::Parameter& parameter, lutlib::Knots& knots, lutlib::Knot knot);

/// Moves a knot to a place within the parameter's ranges and between its neighbours.
void move_knot(const lutlib::Parameter& parameter, lutlib::Knots& knots, std::size_t index,
               lutlib::Knot to);

/// Deletes a knot; a curve whose other knots are neutral becomes the neutral curve, without knots.
void remove_knot(const lutlib::Parameter& parameter, lutlib::Knots& knots, std::size_t index);

/// The knot nearest to `at`, measured in widths and heights of the view, within `reach` of it.
std::optional<std::size_t> knot_at(const CurveView& view, const lutlib::Knots& knots,
                                   lutlib::Knot at, lutlib::Knot reach);

} // namespace preview::editor
