// Colours under an alpha: a look sees them straight, and some files store them multiplied by it.
#pragma once

#include "lutlib/io/image.h"

#include <utility>
#include <vector>

namespace lutlib::io {

/// Colours that have no straight form: those of pixels of alpha 0 in a premultiplied picture, which
/// only add light. Index of the pixel, and its colour.
using LightOnly = std::vector<std::pair<std::size_t, Rgb>>;

/// Divides the colours of a premultiplied picture (image.premultiplied) by their alpha; the answer
/// is what could not be divided, left as it is. Nothing happens to any other picture.
LightOnly make_straight(FloatImage& image);

/// Multiplies the colours by their alpha, and puts back what has none.
void premultiply(FloatImage& image, const LightOnly& light = {});

} // namespace lutlib::io
