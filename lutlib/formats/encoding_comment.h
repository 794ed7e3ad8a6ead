// The encodings of a look as comment lines of a text format:
//
//   # Input encoding: slog3/sgamut3.cine
//   # Output encoding: gamma24/rec709
//
// A name is what encoding_named() knows; another is kept as it is. Letters before the colon may be
// of any case, and blanks on either side of it.
#pragma once

#include "lutlib/lut.h"

#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

/// Takes the encoding from a comment, given without its marker. False where it is none, or where
/// one has been taken before.
bool take_encoding(std::string_view comment, EncodingNames& names);

/// What to do where a comment names another encoding than the one taken before; empty where it does
/// not.
std::string encoding_contradiction(std::string_view comment, const EncodingNames& names);

/// Whether a comment speaks of a side whose encoding is known: written beside the comment that says
/// it, it would repeat or contradict that.
bool is_superseded(std::string_view comment, const EncodingNames& names);

/// The comments that say them, without markers; none for what is not known.
std::vector<std::string> encoding_comments(const EncodingNames& names);

} // namespace lutlib
