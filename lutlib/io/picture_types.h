// The types of picture files that a LUT may come in, beside PNG: OpenImageIO reads them all.
#pragma once

#include "lutlib/format.h"

#include <array>
#include <string>
#include <string_view>

namespace lutlib::io {

struct PictureType {
    std::string_view name;
    Extensions extensions;
    /// How its files begin; empty where that tells nothing, and the extension must.
    std::array<std::string_view, 2> magics{};
    /// What it does to codes, a sentence without its full stop. Null where it keeps them.
    std::string_view harm{};
    /// Whether it did so to this file; null: always.
    bool (*harms)(std::string_view bytes) = nullptr;
};

/// Whether a WebP file was compressed with losses, which its first chunk of pixels tells.
bool is_lossy_webp(std::string_view bytes);

inline constexpr auto picture_types = std::to_array<PictureType>({
    {.name = "TGA", .extensions = {"tga"}},
    {.name = "TIFF",
     .extensions = {"tif", "tiff"},
     .magics = {std::string_view("II*\0", 4), std::string_view("MM\0*", 4)}},
    {.name = "BMP", .extensions = {"bmp"}},
    {.name = "JPEG",
     .extensions = {"jpg", "jpeg"},
     .magics = {"\xff\xd8\xff"},
     .harm = "JPEG compresses with losses, so its codes are only near those that were saved; save "
             "the look as PNG"},
    {.name = "EXR", .extensions = {"exr"}, .magics = {"v/1\x01"}},
    {.name = "DPX", .extensions = {"dpx"}, .magics = {"SDPX", "XPDS"}},
    {.name = "WebP",
     .extensions = {"webp"},
     .magics = {"RIFF"},
     .harm = "this WebP is compressed with losses, so its codes are only near those that were "
             "saved; save the look as PNG",
     .harms = is_lossy_webp},
    {.name = "GIF",
     .extensions = {"gif"},
     .magics = {"GIF8"},
     .harm = "GIF keeps 256 colours at most, so its codes are only near those that were saved; "
             "save the look as PNG"},
    {.name = "PPM", .extensions = {"ppm", "pnm"}, .magics = {"P6\n"}},
    {.name = "Radiance HDR",
     .extensions = {"hdr"},
     .magics = {"#?RADIANCE"},
     .harm = "Radiance HDR keeps 8 bits a channel of the brightest, so its codes are only near "
             "those that were saved; save the look as PNG or EXR"},
    {.name = "PSD", .extensions = {"psd"}, .magics = {"8BPS"}},
});

/// By how the bytes begin, else by the extension of `file`; null for none of these.
const PictureType* picture_type_of(std::string_view bytes, std::string_view file);
/// Whether they begin as such a file does.
bool begins_as_picture(std::string_view bytes);

} // namespace lutlib::io
