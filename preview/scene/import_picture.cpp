#include "lutlib/codes.h"
#include "lutlib/error.h"
#include "lutlib/io/image.h"
#include "preview/scene/import_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace preview {

namespace {

using lutlib::Error;

struct Sides {
    std::size_t width = 0, height = 0;
};

std::size_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

/// ISO/IEC 15948: the chunk IHDR comes first.
std::optional<Sides> png_sides(std::string_view bytes) {
    if (!bytes.starts_with("\x89PNG\r\n\x1a\n") || bytes.size() < 24) {
        return std::nullopt;
    }
    return Sides{big_endian(bytes, 16, 4), big_endian(bytes, 20, 4)};
}

/// ITU-T T.81, B.2.2: a segment SOF0 to SOF15 has the sides; C4, C8 and CC are none of them.
std::optional<Sides> jpeg_sides(std::string_view bytes) {
    if (!bytes.starts_with("\xff\xd8\xff")) {
        return std::nullopt;
    }
    for (std::size_t at = 2; at + 9 <= bytes.size();) {
        const std::size_t marker = big_endian(bytes, at, 2);
        if (marker == 0xffff) {
            ++at; // fill
            continue;
        }
        if (marker >= 0xffc0 && marker <= 0xffcf && marker != 0xffc4 && marker != 0xffc8 &&
            marker != 0xffcc) {
            return Sides{big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2)};
        }
        at += 2 + big_endian(bytes, at + 2, 2);
    }
    return std::nullopt;
}

std::uint8_t byte_of(float value) {
    return static_cast<std::uint8_t>(lutlib::CodeDepth{8}.code(value));
}

} // namespace

Picture picture_of(std::string_view bytes, const std::string& file) {
    std::optional<Sides> sides = png_sides(bytes);
    const bool is_png = sides.has_value();
    if (!is_png) {
        sides = jpeg_sides(bytes);
    }
    if (!sides) {
        throw Error("a texture is neither a PNG nor a JPEG picture", {file, 0, {}});
    }
    if (sides->width == 0 || sides->height == 0 || sides->width > import_limits.picture_side ||
        sides->height > import_limits.picture_side ||
        sides->width * sides->height > import_limits.texels) {
        throw Error(
            fmt::format("a texture of {} x {} is beyond the limits", sides->width, sides->height),
            {file, 0, {}});
    }
    const lutlib::io::FloatImage image =
        lutlib::io::decode_image(bytes, is_png ? "png" : "jpg", file);
    Picture out;
    out.name = file;
    out.width = static_cast<std::uint32_t>(image.width);
    out.height = static_cast<std::uint32_t>(image.height);
    out.rgba.reserve(image.rgba.size());
    for (const float value : image.rgba) {
        out.rgba.push_back(byte_of(value));
    }
    return out;
}

} // namespace preview
