// Pictures of any file type as float RGBA. PNG goes through png.h; everything else through
// OpenImageIO, which is loaded on first use (module.h). Values are never converted between colour
// spaces: integer codes c of b bits become c / (2^b - 1), floats stay as they are.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/io/picture_source.h"
#include "lutlib/io/sample_buffer.h"

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

/// Rows from the top, four floats a pixel: red, green, blue, alpha, found by their names where the
/// file type has names. Grey is repeated; a file without alpha gets 1. Alpha is as stored: neither
/// multiplied in nor divided out.
struct FloatImage {
    int width = 0, height = 0;
    std::vector<float> rgba;
    int channels = 4;             ///< of the picture: 1 grey, 3 colours, and 1 for alpha
    bool alpha = false;           ///< the file stores alpha
    bool premultiplied = false;   ///< its colours are stored multiplied by alpha, as in EXR
    Depth depth = Depth::float32; ///< the file's own
    bool srgb_tag = false;        ///< a PNG with the chunk sRGB
    bool profile_tag = false;     ///< a PNG with a colour profile, the chunk iCCP
    bool holds_light = false;     ///< its file type is defined to hold linear light (EXR, HDR)
    /// Red, green, blue and white, x and y each, where the file says them.
    std::optional<std::array<float, 8>> chromaticities{};
    /// What else its file holds.
    std::shared_ptr<const PictureSource> source{};
};

/// What the file says that its values are; nothing where it does not, or says what no row has.
std::optional<Encoding> encoding_of(const FloatImage& image);

/// About how many bytes a picture takes while it is read, graded and written, by its file's header;
/// of one whose header cannot be read 0. Reading it says why.
std::size_t bytes_in_work(const std::string& path);

/// A picture's codes as a PNG has them, without gaps; bytes, or pairs in the machine's order.
struct PictureCodes {
    int bits = 0;           ///< 8 or 16; 0: there are none
    int channels = 3;       ///< 3 RGB or 4 RGBA
    SampleBuffer samples{}; ///< at least what the picture's size needs
};

/// `-` reads standard input. `layer` names one of several pictures in the file
/// (picture_channels.h). Throws Error for what is no readable picture within limits.h. The codes of
/// a PNG go into `codes` where that is given, and rgba stays empty.
FloatImage read_image(const std::string& path, const std::string& layer = {},
                      PictureCodes* codes = nullptr);
/// What rgba would hold of the codes of so many pixels.
std::vector<float> floats_of(const PictureCodes& codes, std::size_t pixels);
FloatImage decode_image(std::string_view bytes, const std::string& extension,
                        const std::string& file, const std::string& layer = {},
                        PictureCodes* codes = nullptr);

struct ImageWriteOptions {
    Depth depth = Depth::half; ///< one of depths_of()
    bool alpha = false;
    std::vector<std::pair<std::string, std::string>> text; ///< kept in PNG files
    /// Written beside the picture as far as the file type holds it; null: nothing.
    const PictureSource* keep = nullptr;
    /// What `keep` says of colour (profile, gamma, primaries) is true of the picture too.
    bool keep_color = true;
};

/// The depths that a picture of the extension of `path` can have, by trial; `-` is a PNG. Throws
/// UsageError when no picture of this type can be written, Error when nothing can be beside `path`.
std::vector<Depth> depths_of(const std::string& path);

/// The one of `held` that loses least of a picture of this depth.
Depth nearest_depth(Depth depth, std::span<const Depth> held);

/// Whether a picture written to `path` stores its colours multiplied by alpha: the type demands it
/// (EXR), or leaves the choice and `keep`, a file of the same type, has chosen so.
bool stores_premultiplied(const std::string& path, const PictureSource* keep);

/// Whether a file of this name says which way up it is; others have to be written upright.
bool holds_orientation(const std::string& path);

/// Writes atomically; the file type is the extension's. Integer samples are clamped to 0..1 (NaN to
/// 0) and rounded to nearest. `-` writes a PNG to standard output. The answer is what of
/// `options.keep` the file does not hold, a phrase each. Throws Error.
std::vector<std::string> write_image(const std::string& path, const FloatImage& image,
                                     const ImageWriteOptions& options);

/// Whether write_codes() writes files of this name.
bool holds_codes(const std::string& path);
/// The same of codes, of the size of `image`, into a PNG of their depth and channels.
std::vector<std::string> write_codes(const std::string& path, const FloatImage& image,
                                     PictureCodes codes, const ImageWriteOptions& options);

} // namespace lutlib::io
