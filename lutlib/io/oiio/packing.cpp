#include "lutlib/io/oiio/packing.h"

#include "lutlib/error.h"

#include <algorithm>
#include <array>

namespace lutlib::io {
namespace {

struct Packing {
    std::string_view type;
    std::string_view compression; ///< OpenImageIO's name; empty: any
    std::size_t ratio;            ///< of the pixels' bytes to the file's, at best
};

// Run lengths of a byte pack 128 into 1 or 2. Deflate packs 1032 into 1 (RFC 1951); LZW of 12 bits
// at most 4096 into 1.5; a JPEG block of 64 samples takes 1 bit, and with chroma halved 768
// bytes 6.
constexpr std::array<Packing, 18> packings{{{"targa", "", 128},
                                            {"hdr", "", 128},
                                            {"bmp", "", 256},
                                            {"sgi", "", 128},
                                            {"softimage", "", 256},
                                            {"psd", "", 256},
                                            {"dpx", "", 1},
                                            {"cineon", "", 2},
                                            {"pnm", "", 1},
                                            {"dds", "", 32},
                                            {"jpeg", "", 1100},
                                            {"tiff", "none", 1},
                                            {"tiff", "packbits", 128},
                                            {"tiff", "zip", 1100},
                                            {"tiff", "jpeg", 1100},
                                            {"tiff", "lzw", 3000},
                                            {"openexr", "zip", 1100},
                                            {"openexr", "zips", 1100}}};

} // namespace

void check_packing(const OIIO::ImageSpec& spec, std::string_view type, std::size_t file_bytes,
                   const std::string& file, bool partial) {
    const std::string compression(spec.get_string_attribute("compression"));
    const auto* const row = std::find_if(packings.begin(), packings.end(), [&](const Packing& p) {
        return p.type == type && (p.compression.empty() || p.compression == compression);
    });
    if (row == packings.end()) {
        return;
    }
    const std::size_t bits = static_cast<std::size_t>(std::max(
        1, spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(spec.format.size()) * 8)));
    const std::size_t bytes = spec.image_pixels() * static_cast<std::size_t>(spec.nchannels) *
                              std::min(bits, spec.format.size() * 8) / 8;
    if (bytes / row->ratio / (partial ? 64 : 1) > file_bytes) {
        throw Error("the picture is cut short: its header tells of " + std::to_string(spec.width) +
                        "x" + std::to_string(spec.height) +
                        " pixels, more than the file can hold; fetch or export it again",
                    {file, 0, {}});
    }
}

} // namespace lutlib::io
