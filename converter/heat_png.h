// Where a look misses a picture, as a picture.
#pragma once

#include "lutlib/paint/on_picture.h"

#include <string>

namespace converter {

/// A PNG: dE2000 as colours, from 0 (blue) to 10 (yellow), grey where nothing was compared.
std::string heat_png(const lutlib::OnPicture& on);

} // namespace converter
