// FXAA in double; shaders/fxaa.comp explains it.
#pragma once

#include "preview/reference/image.h"

namespace preview::reference {

/// `strength` 0..1 scales how far a fetch is shifted.
Image fxaa(const Image& picture, double strength = 1);

} // namespace preview::reference
