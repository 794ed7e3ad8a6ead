// Recognises a LUT that was kept in a palette.
#pragma once

#include "lutlib/verify/diagnose.h"

#include <optional>
#include <string>

namespace lutlib {

/// In words, when the picture has no more colours than a palette of 256 holds, the look's codes
/// many more, and each texel is one of those near its own: an error of at most a tenth of the
/// codes' variance, which also holds where colours were dithered. Pictures of greys alone, as a
/// look without colour makes them, are left out.
std::optional<std::string> few_colors(const CodeImage& picture, const Engine& engine, int size,
                                      const Transform& look);

} // namespace lutlib
