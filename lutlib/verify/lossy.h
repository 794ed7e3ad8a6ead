// Recognises what a lossy picture format leaves behind in a LUT.
#pragma once

#include "lutlib/verify/diagnose.h"

#include <optional>
#include <string>

namespace lutlib {

/// In words, when the codes differ from the look as a lossy format makes them differ: nearly
/// everywhere, by more than rounding, and with errors that cancel out in blocks of 8 x 8 texels,
/// whose means such formats keep best. Another look's errors are smooth and do not cancel: their
/// block means hold two thirds of the squared error and more, a lossy format's a third at most
/// (JPEG of qualities 60 to 95 on four looks and three layouts; at 30, half).
std::optional<std::string> lossy_noise(const CodeImage& picture, const Engine& engine, int size,
                                       const Transform& look);

} // namespace lutlib
