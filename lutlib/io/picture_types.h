// The types of picture files that are read, PNG by our own reader and the others by OpenImageIO.
#pragma once

#include "lutlib/format.h"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace lutlib::io {

struct PictureType {
    /// Bytes that a file has at a place; none where it is empty.
    struct Mark {
        std::string_view bytes{};
        std::size_t at = 0;
    };

    std::string_view name;
    std::string_view reader; ///< OpenImageIO's name of the type
    Extensions extensions;
    /// How its files begin; none where `may_be` must tell.
    std::array<Mark, 4> marks{};
    /// Whether a file without any type's mark, of which these are the first bytes, may be one.
    /// Null: it may not.
    bool (*may_be)(std::string_view head) = nullptr;
    /// What it does to codes, a sentence without its full stop. Null where it keeps them.
    std::string_view harm{};
    /// Whether it did so to this file; null: always.
    bool (*harms)(std::string_view bytes) = nullptr;
};

std::span<const PictureType> picture_types();

/// By a mark, else by the extension of `file`; null for none of these.
const PictureType* picture_type_of(std::string_view bytes, std::string_view file);
/// Whether they have a mark that no text begins with by chance.
bool begins_as_picture(std::string_view bytes);
/// `extension` in lower case.
bool is_picture_extension(std::string_view extension);

/// How many first bytes reader_of needs.
inline constexpr std::size_t enough_to_tell_type = 64;

/// OpenImageIO's name of the type that a file's first bytes tell; its name tells nothing. Throws
/// Error, about `file`, for what is none of these.
std::string_view reader_of(std::string_view head, const std::string& file);
/// Whether OpenImageIO's type of that name is among these.
bool is_read_by(std::string_view reader);

} // namespace lutlib::io
