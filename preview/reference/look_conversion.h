// What a look makes of a texel with what is converted around it, in double.
#pragma once

#include "lutlib/transform.h"
#include "preview/finish/tonemaps.h"
#include "preview/look/look_conversion.h"

namespace preview::reference {

/// The sRGB codes that are shown of a texel: of linear sRGB light where the look stands before the
/// tone map, else of the picture's codes. They are encoded as the look takes them, go through it,
/// and are read as it gives them: as light, which is tone-mapped, or as the picture.
lutlib::RgbD graded(lutlib::RgbD texel, const LookConversion& conversion,
                    const lutlib::Transform& look, const Tonemap& tonemap);

} // namespace preview::reference
