// Where in the cells of a union grid errors may exceed those at its colours.
#pragma once

#include "lutlib/metrics/error_samples.h"
#include "lutlib/metrics/viewing.h"
#include "lutlib/transform.h"

#include <vector>

namespace lutlib {

/// Between the corners of a cell two maps may differ by more than at the corners, for one of them
/// may bend along a diagonal where the other does not. By how much follows from the corners: a bend
/// along a diagonal of a face moves its middle by a quarter of f(0,0) - f(1,0) - f(0,1) + f(1,1),
/// and one along a diagonal of the cell by the distance of that diagonal's mean from that of all
/// corners. To the mean error of the corners this of both maps is added, in code values and as
/// eye_form.h has it around the colour.
///
/// Gives the middles of the edges, faces and volume of the cells of the largest bounds, and the
/// colours of the grid with the largest errors. Evaluates both maps once at every colour of the
/// grid, which must be fewer than 2^32. The same on every machine.
std::vector<Rgb> suspects(const Transform& a, const Transform& b, const UnionAxes& axis,
                          const Viewing& viewing, const SuspectCount& count);

} // namespace lutlib
