// The editor of an operator's curves: one plot, in which one of them is edited by mouse, typed
// numbers or a colour picked in the picture.
#pragma once

#include "preview/panels/ui.h"

#include <span>
#include <string>

namespace preview::panels {

/// Of curves over one axis; those whose ranges differ have each their own heights in the plot, and
/// the axis names are those of the curve that is edited. A click sets a knot, which
/// can be dragged; the right button deletes one. `start_picking` gets a colour for a knot: of the
/// parameter of that number. True when a curve changed.
bool curve_editor(Ui& ui, std::span<const lutlib::Parameter> parameters,
                  std::span<lutlib::Value> values, const std::string& place,
                  const std::function<void(std::size_t parameter)>& start_picking);

/// A knot on the curve as it is, at that place of its axis, in as many digits as the mouse gives;
/// its number.
std::size_t add_knot_on_curve(const lutlib::Parameter& parameter, lutlib::Knots& knots, double x);

} // namespace preview::panels
