// The controls of one operator, as its descriptor tells: wheels, curves, colours to be picked and
// numbers.
#pragma once

#include "preview/panels/ui.h"

#include <string>

namespace preview::panels {

/// Of `operation`, which stands at `at` in the recipe, or will once it is changed: then `at` is the
/// number of its operators. True when a value changed. Controls are called by `place` and the names
/// of parameters.
bool operator_controls(Ui& ui, lutlib::Operation& operation, std::size_t at,
                       const std::string& place);

/// Waits for a colour of the picture, which sets a knot of the operator's curve `parameter`; the
/// plot is called `plot`.
void start_picking_knot(Ui& ui, const lutlib::Op& op, std::size_t at, std::size_t parameter,
                        const std::string& plot);

} // namespace preview::panels
