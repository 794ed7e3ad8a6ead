#include "lutlib/io/picture_types.h"

#include "lutlib/io/file.h"

#include <algorithm>

namespace lutlib::io {
namespace {

bool begins_as(const PictureType& type, std::string_view bytes) {
    return std::any_of(type.magics.begin(), type.magics.end(), [&](std::string_view magic) {
        return !magic.empty() && bytes.starts_with(magic);
    });
}

} // namespace

bool is_lossy_webp(std::string_view bytes) {
    // A RIFF file: its name, then chunks of a name, a length and bytes, padded to even lengths.
    constexpr std::size_t head = 12, chunk_head = 8;
    for (std::size_t at = head; at + chunk_head <= bytes.size();) {
        const std::string_view name = bytes.substr(at, 4);
        if (name == "VP8 " || name == "VP8L") {
            return name == "VP8 ";
        }
        std::size_t length = 0;
        for (std::size_t i = 4; i-- > 0;) {
            length = length << 8 | static_cast<unsigned char>(bytes[at + 4 + i]);
        }
        at += chunk_head + length + length % 2;
    }
    return false;
}

const PictureType* picture_type_of(std::string_view bytes, std::string_view file) {
    const auto first = [](auto&& is_it) {
        const auto* const row = std::find_if(picture_types.begin(), picture_types.end(), is_it);
        return row == picture_types.end() ? nullptr : &*row;
    };
    const PictureType* const begun =
        first([&](const PictureType& type) { return begins_as(type, bytes); });
    const std::string extension = extension_of(std::string(file));
    return begun
               ? begun
               : first([&](const PictureType& type) { return type.extensions.contain(extension); });
}

bool begins_as_picture(std::string_view bytes) {
    return picture_type_of(bytes, {}) != nullptr;
}

} // namespace lutlib::io
