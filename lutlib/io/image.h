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

/// Of a sample.
constexpr std::size_t bytes_of(Depth depth) {
    return depth == Depth::uint8 ? 1 : depth == Depth::float32 ? 4 : 2;
}

/// What a file says of its picture.
struct ImageInfo {
    int width = 0, height = 0;
    int channels = 4;             ///< of the picture: 1 grey, 3 colours, and 1 for alpha
    bool alpha = false;           ///< the file stores alpha
    bool premultiplied = false;   ///< its colours are stored multiplied by alpha, as in EXR
    Depth depth = Depth::float32; ///< the file's own
    bool srgb_tag = false;        ///< a PNG with the chunk sRGB
    bool profile_tag = false;     ///< a PNG with a colour profile, the chunk iCCP
    bool holds_light = false;     ///< its file type is defined to hold linear light (EXR, HDR)
    /// That the file does not hold, of a picture that was read in part. Their samples are 0.
    std::size_t missing_pixels = 0;
    /// Red, green, blue and white, x and y each, where the file says them.
    std::optional<std::array<float, 8>> chromaticities{};
    /// What else its file holds.
    std::shared_ptr<const PictureSource> source{};

    std::size_t pixels() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
};

/// Rows from the top, four floats a pixel: red, green, blue, alpha, found by their names where the
/// file type has names. Grey is repeated; a file without alpha gets 1. Alpha is as stored: neither
/// multiplied in nor divided out.
struct FloatImage : ImageInfo {
    std::vector<float> rgba;
};

/// The same as the file stores it: samples of `depth`, 3 a pixel, or 4 with alpha, in the machine's
/// order of bytes.
struct SampleImage : ImageInfo {
    SampleBuffer samples{};

    std::size_t samples_a_pixel() const { return alpha ? 4 : 3; }
    /// What `samples` hold at least.
    std::size_t bytes() const { return pixels() * samples_a_pixel() * bytes_of(depth); }
};

/// What the file says that its values are; nothing where it does not, or says what no row has.
std::optional<Encoding> encoding_of(const ImageInfo& image);

/// About how many bytes a picture takes while it is read, graded and written, by its file's header;
/// of one whose header cannot be read 0. Reading it says why.
std::size_t bytes_in_work(const std::string& path);

struct ImageReadOptions {
    std::string layer{};  ///< one of several pictures in the file (picture_channels.h)
    bool partial = false; ///< of a picture that is not whole, what is there; else that is an error
};

/// `-` reads standard input. Throws Error for what is no readable picture within limits.h.
SampleImage read_samples(const std::string& path, const ImageReadOptions& options = {});
SampleImage decode_samples(std::string_view bytes, const std::string& extension,
                           const std::string& file, const ImageReadOptions& options = {});
FloatImage read_image(const std::string& path, const ImageReadOptions& options = {});
FloatImage decode_image(std::string_view bytes, const std::string& extension,
                        const std::string& file, const ImageReadOptions& options = {});

struct ImageWriteOptions {
    Depth depth = Depth::half; ///< one of depths_of(), of the file that write_image() makes
    bool alpha = false;        ///< whether that has alpha
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

/// Whether a file of this name says which way up a picture is, as those do that `keep` is of;
/// others have to be written upright.
bool holds_orientation(const std::string& path, const PictureSource& keep);

/// Writes atomically; the file type is the extension's. Integer samples are clamped to 0..1 (NaN to
/// 0) and rounded to nearest. `-` writes a PNG to standard output. The answer is what of
/// `options.keep` the file does not hold, a phrase each. Throws Error.
std::vector<std::string> write_image(const std::string& path, const FloatImage& image,
                                     const ImageWriteOptions& options);

/// Memory for samples like those of `image` on their way to `path`, from where another process can
/// take them without a copy; empty where none is going to.
SampleBuffer samples_for(const std::string& path, const SampleImage& image);

/// write_image() of samples as they are; their depth is one of depths_of().
std::vector<std::string> write_samples(const std::string& path, SampleImage image,
                                       const ImageWriteOptions& options);

} // namespace lutlib::io
