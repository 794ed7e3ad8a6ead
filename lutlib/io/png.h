// PNG pictures as exact integer codes, through libspng: the picture half of every engine's
// contract.
//
// Codes are never converted: no gamma, no colour profile, no sRGB decoding. What the file says
// about its encoding is reported beside them.
#pragma once

#include "lutlib/code_image.h"
#include "lutlib/io/sample_buffer.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lutlib::io {

/// A chunk that says something beside the pixels, as it stands in the file: length, name, data and
/// check sum.
struct PngChunk {
    std::string bytes;
    bool about_color = false; ///< gamma, primaries, profile: wrong once the codes' meaning changed

    std::string name() const { return bytes.substr(4, 4); }
};

/// The chunks of a whole PNG file that stay true of other pixels of the same size: colour (sRGB,
/// gAMA, cHRM, iCCP, cICP, mDCV, cLLI), text, Exif, resolution, time.
std::vector<PngChunk> kept_chunks(std::string_view png);

/// What a PNG file says of its pixels.
struct PngTags {
    bool srgb_tag = false;      ///< an sRGB chunk
    bool gamma_tag = false;     ///< a gAMA chunk
    bool profile_tag = false;   ///< an iCCP chunk
    bool primaries_tag = false; ///< a cHRM chunk
    bool grey = false;          ///< the file stores one grey value a pixel; samples repeat it
    bool palette = false;       ///< the file stores indices; samples are the colours, 8 bits
    bool interlaced = false;
    /// tEXt, zTXt and iTXt keys with their texts, in the file's order.
    std::vector<std::pair<std::string, std::string>> text;
    std::string icc_profile{};      ///< of an iCCP chunk, unpacked
    std::vector<PngChunk> chunks{}; ///< to write as they are; none is read
};

/// A PNG file: its codes, of 8 or 16 bits, and what it says of them.
struct PngImage : CodeImage, PngTags {};

/// The same for pictures that are large: samples of a byte, or of two in the machine's order.
struct PngPicture : PngTags {
    int width = 0, height = 0;
    int channels = 3; ///< 3 RGB or 4 RGBA
    int bits = 8;     ///< or 16
    int missing_rows =
        0; ///< the last ones, which a file that was read in part does not hold: zeros
    SampleBuffer samples{};
};

/// Whether bytes begin as a PNG file does.
bool is_png(std::string_view bytes);

/// Of its header (ISO/IEC 15948, IHDR comes first), each side held to limits.h; 0 without one.
std::size_t pixels_of_png(std::string_view head);

/// Decodes a PNG file of any colour type and depth. Grey and palette become RGB; 1, 2 and 4 bit
/// grey is scaled to 8; transparency becomes alpha. Throws Error for anything that is not a whole,
/// undamaged PNG within limits.h; sizes are checked before pixels are allocated. `file` names the
/// input in errors. With `partial` the rows that come before the damage are taken, of a picture
/// that is not interlaced and has one.
PngPicture read_png_picture(std::string_view bytes, const std::string& file, bool partial = false);
PngImage read_png(std::string_view bytes, const std::string& file);

/// The bytes of an RGB or RGBA file; srgb_tag, icc_profile, text and chunks are written, the other
/// tags are not. Keys are 1..79 Latin-1 characters; keys with an empty text are left out. Small
/// files are packed closely, large ones fast and on every core (png_rows.h). Throws Error for codes
/// that do not fit.
std::string write_png(const PngPicture& picture);
std::string write_png(const PngImage& image);

} // namespace lutlib::io
