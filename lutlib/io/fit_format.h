// A look brought into the form that a file format can hold, and what that costs.
#pragma once

#include "lutlib/format.h"

#include <vector>

namespace lutlib::io {

struct FitToFormat {
    Lut lut;
    std::vector<Loss> losses;
};

/// `cube_size` 0 keeps the cube's own size, or takes 65 where a cube must be made. A look that
/// `holds` can say is returned unchanged. A domain becomes a two-entry shaper, and a cube's domain
/// part of its shaper, where that keeps everything; else the look is resampled, over the inputs
/// that the format reaches, and the largest difference is measured and reported, as is what the
/// loss of the interpolation that it asks for, and rounding and clamping to the format's numbers,
/// take. Throws Error for a size outside limits.h,
/// UsageError when the format holds neither curve nor cube.
FitToFormat fit_to(const Lut& lut, const Holds& holds, int cube_size = 0);

/// Whether the format can say this look's tables and domains as they are.
bool can_hold(const Lut& lut, const Holds& holds);

} // namespace lutlib::io
