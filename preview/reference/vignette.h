// The vignette in double; shaders/vignette.comp explains it.
#pragma once

#include "preview/reference/image.h"

namespace preview::reference {

/// `angle` is that of view from corner to corner, in degrees; `strength` 0..1.
Image vignette(const Image& light, double strength, double angle);

} // namespace preview::reference
