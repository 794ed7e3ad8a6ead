// A look that a file held, made ready for the lookup that shall read it.
#pragma once

#include "lutlib/io/look.h"
#include "preview/look/look_bake.h"
#include "preview/look/look_standing.h"

#include <string>

namespace preview {

/// How a look is used.
struct LookUse {
    const GpuLookup* lookup = nullptr;
    lutlib::LookEncodings encodings{}; ///< in place of what the look says
    PictureCodes picture{};
};

/// Without a lookup: the float table as the look asks to be read, a strip through its own texels. A
/// lookup that reads a picture gets a picture file's codes as they are, and of any other look what
/// `lutconv bake` would make of it. A look that is made for other codes is sampled with its
/// conversions, or stands before the tone map (look_standing.h). Throws lutlib::Error, and
/// UsageError for a picture whose layout the lookup does not read.
LoadedLook look_for(const lutlib::io::Look& look, const LookUse& use);

/// What people call LOOK of the command line: the file's name without its ending.
std::string look_title(const std::string& path);

/// LOOK of the command line: a file, or `none`.
LoadedLook load_look(const std::string& path, const LookUse& use);

} // namespace preview
