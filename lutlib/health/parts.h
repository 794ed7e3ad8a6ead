// What examine() is made of. Each part fills its own members of Health.
#pragma once

#include "lutlib/health/health.h"

namespace lutlib::health {

/// The size of the rounding in which the look's numbers were stored: half a code where all of them
/// are codes of 8, 10 or 12 bits, else the last of six decimals, else the last bit of tiny values.
double rounding_of(const Lut& lut);

/// Whole colours of finite values.
bool finite(const Rgb& c);

/// `cube` is the look's own, or the identity over its curve's outputs where it has none.
void examine_values(const Lut& lut, Health& out);
void examine_cells(const Lut& lut, const Lut3D& cube, double rounding, Health& out);
void examine_curve(const Lut1D& curve, const Lut3D* cube, double rounding, Health& out);
void examine_neutrals(const Lut& lut, double rounding, Health& out);
void examine_black(const Lut& lut, Health& out);
void predict_errors(const Lut& lut, double rounding, Health& out);

} // namespace lutlib::health
