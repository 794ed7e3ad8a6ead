// Values in the words of messages and losses.
#pragma once

#include "lutlib/lut.h"

#include <string>

namespace lutlib::io {

/// "0..4", or "0,0,-1..1,1,2" where channels differ.
std::string text_of(const Domain& domain);

/// "a cube of 33 nodes per axis", "a curve of 1024 entries", or both.
std::string shape_of(const Lut& lut);

} // namespace lutlib::io
