// What an ICC profile calls itself, and the encoding that the well-known names stand for.
#pragma once

#include "lutlib/color/encoding.h"

#include <optional>
#include <string>
#include <string_view>

namespace lutlib::io {

/// The profile's description, its tag `desc`, of version 2 (ASCII) or 4 (the first of its
/// languages, characters beyond ASCII as '?'). Empty where the profile is damaged or has none.
/// ICC.1:2001-04, 6.5.17; ICC.1:2022, 10.15.
std::string icc_description(std::string_view profile);

/// The encoding of a profile whose description begins with a name that everybody writes: sRGB,
/// Display P3, Adobe RGB (1998), Rec. 709 or ITU-R BT.709 with gamma 2.4. Nothing for any other.
std::optional<Encoding> encoding_of_profile(std::string_view profile);

} // namespace lutlib::io
