// Looks whose channels do not mix, as 1D tables: what resampling, composing and blending curves
// make.
#pragma once

#include "lutlib/lut.h"
#include "lutlib/transform.h"

namespace lutlib {

/// A 1D table alone, or nothing at all: no channel of a result depends on another.
bool is_curves(const Lut& lut);

/// A transform whose channels do not mix, as a table of `size` entries over `domain`. Throws Error
/// for a size or a domain outside limits.h.
Lut1D sample_curve(const Transform& transform, const Domain& domain, int size);

/// The same with as many entries as it takes: of `least`, twice the steps, four times and so on up
/// to limits.h, the first that lies, between its entries too, within `tolerance` of the table's own
/// range; where none does, as at a jump, the first whose error is as good as the least of them.
Lut1D sample_curve_closely(const Transform& transform, const Domain& domain, int least,
                           double tolerance);

/// Of sample_curve_closely() where tables of curves are made: far below 1e-4, where a float's
/// sixteen bits of a picture begin.
inline constexpr double curve_tolerance = 1e-5;

} // namespace lutlib
