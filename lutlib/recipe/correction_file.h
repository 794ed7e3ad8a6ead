// Files of ASC CDL corrections: .cc has one, .ccc and .cdl have several. Read with what of XML such
// files use; no entity is expanded but XML's own five and numbered characters.
#pragma once

#include "lutlib/recipe/color_correction.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

struct CorrectionFormat {
    std::string_view extension; ///< without the dot
    std::string_view label;
    std::string_view root;     ///< the element that all others are in
    std::string_view around{}; ///< the element around each correction, where there is one
    bool holds_many() const { return extension != "cc"; }
};
std::span<const CorrectionFormat> correction_formats();
/// By the extension of `file`, in any case; null for none of theirs.
const CorrectionFormat* correction_format_of(const std::string& file);

/// All corrections of a file, whose format its own root tells. Throws Error with the line.
std::vector<ColorCorrection> parse_corrections(std::string_view text, const std::string& file);

/// The place of the first correction that a list calls so; without a name the first of all. Throws
/// UsageError that lists the names.
std::size_t correction_named(std::span<const ColorCorrection> corrections, const std::string& id);

/// What a list calls it: its id, else its number.
std::string name_of(std::span<const ColorCorrection> corrections, std::size_t at);

/// A new file of that format with one correction. Throws UsageError for an id that XML cannot hold.
std::string correction_text(const ColorCorrection& correction, const CorrectionFormat& format);

/// The file of several with this correction in place of the first of its id, else behind the last;
/// all else stays byte by byte. Throws Error for a file that cannot be read, or that is one of a
/// single correction, and UsageError as above.
std::string with_correction(std::string_view text, const std::string& file,
                            const ColorCorrection& correction);

/// Whether the text is one that these functions have written.
bool is_correction_text(std::string_view text, const std::string& file);

} // namespace lutlib
