// The rows of post_effects(). A new effect is a file beside this one, named in CMakeLists.txt, its
// line here and its line in the table of effects.cpp.
#pragma once

#include "preview/effects/effect.h"

namespace preview::effect {

extern const PostEffect chromatic_aberration, depth_of_field, film_grain, fxaa, glitch, paintbrush,
    pointillism, sharpen, vaporwave, vignette;

} // namespace preview::effect
