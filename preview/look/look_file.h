// A look that a file held, made ready for the lookup that shall read it.
#pragma once

#include "lutlib/io/look.h"
#include "lutlib/recipe/placement.h"
#include "preview/look/look_bake.h"

#include <string>

namespace preview {

/// The codes that looks get; what they give is shown as sRGB.
struct PictureCodes {
    lutlib::Encoding encoding = lutlib::srgb();
    bool convert = true; ///< for looks that are made for other codes
    friend bool operator==(const PictureCodes&, const PictureCodes&) = default;
};

/// How a look is used.
struct LookUse {
    const GpuLookup* lookup = nullptr;
    lutlib::LookEncodings encodings{}; ///< in place of what the look says
    PictureCodes picture{};
};

/// What follows for a look of these encodings.
lutlib::LookPlace place_of(const lutlib::LookEncodings& look, const PictureCodes& picture = {});

/// Without a lookup: the float table as the look asks to be read, a strip through its own texels. A
/// lookup that reads a picture gets a picture file's codes as they are, and of any other look what
/// `lutconv bake` would make of it. A look that is made for other codes is sampled with its
/// conversions. Throws lutlib::Error, and UsageError for a picture whose layout the lookup does not
/// read.
LoadedLook look_for(const lutlib::io::Look& look, const LookUse& use);

/// LOOK of the command line: a file, or `none`.
LoadedLook load_look(const std::string& path, const LookUse& use);

} // namespace preview
