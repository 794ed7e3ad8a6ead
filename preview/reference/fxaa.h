// FXAA in double; shaders/fxaa.comp explains it.
#pragma once

#include "preview/reference/image.h"

namespace preview::reference {

Image fxaa(const Image& picture);

} // namespace preview::reference
