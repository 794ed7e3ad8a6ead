// What a look before the tone map makes of scene light, in double.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/transform.h"
#include "preview/finish/tonemaps.h"

namespace preview::reference {

/// The sRGB codes that are shown of linear sRGB light: encoded as `fed`, through the look, read as
/// `gives`, and tone-mapped; a look that gives the picture itself is converted to sRGB instead.
lutlib::RgbD graded_light(lutlib::RgbD light, const lutlib::Encoding& fed,
                          const lutlib::Encoding& gives, const lutlib::Transform& look,
                          const Tonemap* tonemap);

} // namespace preview::reference
