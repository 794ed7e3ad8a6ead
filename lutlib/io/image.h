// Pictures of any file type as float RGBA. PNG goes through png.h; everything else through
// OpenImageIO, which is loaded on first use (module.h). Values are never converted between colour
// spaces: integer codes c of b bits become c / (2^b - 1), floats stay as they are.
#pragma once

#include "lutlib/color/encoding.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib::io {

/// How a file stores a sample.
enum class Depth { uint8, uint16, half, float32 };

struct DepthInfo {
    Depth depth;
    std::string_view name;
    bool integer; ///< codes over 0..1; values outside are clamped
};
std::span<const DepthInfo> depths();
const DepthInfo& info_of(Depth depth);

/// Rows from the top, four floats a pixel: red, green, blue, alpha. Grey is repeated; a file
/// without alpha gets 1. Alpha is as stored: neither multiplied in nor divided out.
struct FloatImage {
    int width = 0, height = 0;
    std::vector<float> rgba;
    int channels = 4;             ///< of the file: 1, 2, 3 or 4 (the first four of more)
    bool alpha = false;           ///< the file stores alpha
    Depth depth = Depth::float32; ///< the file's own
    bool srgb_tag = false;        ///< a PNG with the chunk sRGB
    bool profile_tag = false;     ///< a PNG with a colour profile, the chunk iCCP
    bool holds_light = false;     ///< its file type is defined to hold linear light (EXR, HDR)
    /// Red, green, blue and white, x and y each, where the file says them.
    std::optional<std::array<float, 8>> chromaticities{};
};

/// What the file says that its values are; nothing where it does not, or says what no row has.
std::optional<Encoding> encoding_of(const FloatImage& image);

/// `-` reads standard input. Throws Error for what is no readable picture within limits.h.
FloatImage read_image(const std::string& path);
FloatImage decode_image(std::string_view bytes, const std::string& extension,
                        const std::string& file);

struct ImageWriteOptions {
    Depth depth = Depth::half; ///< one of depths_of()
    bool alpha = false;
    std::vector<std::pair<std::string, std::string>> text; ///< kept in PNG files
};

/// The depths that a picture of the extension of `path` can have, by trial; `-` is a PNG. Throws
/// UsageError when no picture of this type can be written, Error when nothing can be beside `path`.
std::vector<Depth> depths_of(const std::string& path);

/// The one of `held` that loses least of a picture of this depth.
Depth nearest_depth(Depth depth, std::span<const Depth> held);

/// Writes atomically; the file type is the extension's. Integer samples are clamped to 0..1 (NaN to
/// 0) and rounded to nearest. `-` writes a PNG to standard output. Throws Error.
void write_image(const std::string& path, const FloatImage& image,
                 const ImageWriteOptions& options);

} // namespace lutlib::io
