// Pictures on their way to a paint program and back.
#pragma once

#include "lutlib/io/image.h"
#include "lutlib/paint/turn.h"

#include <string>
#include <vector>

namespace converter {

struct PaintPicture {
    lutlib::io::FloatImage image; ///< colours straight
    lutlib::Picture colors;
    std::vector<float> alpha; ///< empty: the file has none
    std::string lossy;        ///< what its file type does to codes; empty: it keeps them
    std::string profile;      ///< what it says of its colours that is no sRGB; empty: nothing
};

/// `-` reads standard input. Throws Error.
PaintPicture read_paint_picture(const std::string& path);

/// The bytes of an RGB PNG of 8 bits that says that lutconv made it.
std::string png_of(const lutlib::Picture& picture, const std::string& title);

} // namespace converter
