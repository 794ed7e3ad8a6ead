// The distances of difference.h of many pairs at once, several times faster: through Highway, with
// the widest vectors that the processor has. The same rules hold for colours that are not finite.
#pragma once

#include "lutlib/color/difference.h"

#include <span>

namespace lutlib {

/// lab_from_linear() of each, within 1e-12 of its largest number.
void lab_from_linear_all(std::span<const RgbD> linear_rec709, std::span<Lab> out);

/// delta_e_2000() of each pair, within 1e-9; but within a rounding error of its jumps, at hues 180
/// degrees apart and a mean hue of 0, the other side may be taken. Exactly 0 for equal colours.
void delta_e_2000_all(std::span<const Lab> a, std::span<const Lab> b, std::span<double> out);

/// delta_e_itp_nits() of each pair, within 1e-9. Exactly 0 for equal colours.
void delta_e_itp_nits_all(std::span<const RgbD> rec2020_nits_a,
                          std::span<const RgbD> rec2020_nits_b, std::span<double> out);

} // namespace lutlib
