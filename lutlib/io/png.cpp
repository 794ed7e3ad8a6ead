#include "lutlib/io/png.h"

#include "lutlib/error.h"
#include "lutlib/io/png_rows.h"
#include "lutlib/limits.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <spng.h>

namespace lutlib::io {
namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
// Deflate cannot pack better than 1032:1, so a picture that claims more cannot be whole.
constexpr std::size_t best_deflate_ratio = 1032;
// One chunk of text or profile, and all of them together.
constexpr std::size_t max_chunk_bytes = std::size_t{16} << 20;
constexpr std::size_t max_chunks_bytes = std::size_t{64} << 20;

// Pictures of which strips for engines are none: half a second of zlib, on one core, for a screen.
constexpr std::size_t least_packed_fast = std::size_t{1} << 20;
constexpr std::string_view end_chunk("\0\0\0\0IEND\xae\x42\x60\x82", 12);

struct Closer {
    void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
using Context = std::unique_ptr<spng_ctx, Closer>;

Context open_context(int flags) {
    Context context(spng_ctx_new(flags));
    if (!context) {
        throw std::bad_alloc();
    }
    return context;
}

void check_read(int status, const std::string& file) {
    if (status == SPNG_OK) {
        return;
    }
    const bool ends_early =
        status == SPNG_IO_EOF || status == SPNG_EOF || status == SPNG_EIDAT_TOO_SHORT;
    throw Error(ends_early ? std::string("the PNG file is cut short; fetch or export it again")
                           : std::string("the PNG file is damaged: ") + spng_strerror(status),
                {file, 0, {}});
}

void check_write(int status) {
    if (status != SPNG_OK) {
        throw Error(std::string("cannot encode the PNG file: ") + spng_strerror(status));
    }
}

void check_size(std::uint64_t width, std::uint64_t height, const std::string& file) {
    const auto side = static_cast<std::uint64_t>(limits::max_image_side);
    if (width == 0 || height == 0 || width > side || height > side ||
        width * height > limits::max_image_pixels) {
        throw Error("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                        " pixels is outside the limits of " + std::to_string(side) +
                        " a side and " + std::to_string(limits::max_image_pixels) + " in all",
                    {file, 0, {}});
    }
}

// Bytes of the picture as the file stores it, before compression.
std::size_t stored_bytes(const spng_ihdr& header) {
    const std::size_t channels = header.color_type == SPNG_COLOR_TYPE_TRUECOLOR         ? 3
                                 : header.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA ? 4
                                 : header.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA ? 2
                                                                                        : 1;
    return (header.width * channels * header.bit_depth + 7) / 8 * header.height;
}

// From the top until one is damaged or missing; the answer is how many are. The rest is cleared.
int decode_rows(spng_ctx* context, PngPicture& image, std::size_t length, int format, int flags,
                const std::string& file) {
    const std::size_t row_bytes = length / static_cast<std::size_t>(image.height);
    int status = spng_decode_image(context, nullptr, 0, format, flags | SPNG_DECODE_PROGRESSIVE);
    check_read(status, file);
    int whole = 0;
    for (std::byte* to = image.samples.data(); whole < image.height; ++whole, to += row_bytes) {
        status = spng_decode_row(context, to, row_bytes);
        const bool is_last = whole + 1 == image.height;
        if (status != SPNG_OK && !(is_last && status == SPNG_EOI)) {
            break;
        }
    }
    if (whole == 0) {
        check_read(status, file);
    }
    const std::size_t there = row_bytes * static_cast<std::size_t>(whole);
    std::fill(image.samples.data() + there, image.samples.data() + length, std::byte{0});
    return image.height - whole;
}

void check_end(spng_ctx* context, std::string_view bytes, const std::string& file) {
    // Text may follow the pixels; this also finds a file that ends before its IEND chunk.
    check_read(spng_decode_chunks(context), file);
    // libspng does not read the check sum of IEND, the last 4 bytes.
    if (bytes.rfind("IEND") + 8 > bytes.size()) {
        check_read(SPNG_IO_EOF, file);
    }
}

// Drops the alpha that libspng adds, in place.
template <class Code>
void drop_alpha(std::span<Code> codes) {
    for (std::size_t i = 0; i < codes.size() / 4; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            codes[3 * i + c] = codes[4 * i + c];
        }
    }
}

void read_text(spng_ctx* context, PngTags& image, const std::string& file) {
    std::uint32_t count = 0;
    const int status = spng_get_text(context, nullptr, &count);
    if (status == SPNG_ECHUNKAVAIL) {
        return;
    }
    check_read(status, file);
    std::vector<spng_text> chunks(count);
    check_read(spng_get_text(context, chunks.data(), &count), file);
    for (const spng_text& chunk : chunks) {
        image.text.emplace_back(chunk.keyword, std::string(chunk.text, chunk.length));
    }
}

void read_tags(spng_ctx* context, PngTags& image, const std::string& file) {
    std::uint8_t intent = 0;
    std::uint32_t gamma = 0;
    spng_iccp profile{};
    spng_chrm_int primaries{};
    image.srgb_tag = spng_get_srgb(context, &intent) == SPNG_OK;
    image.gamma_tag = spng_get_gama_int(context, &gamma) == SPNG_OK;
    image.profile_tag = spng_get_iccp(context, &profile) == SPNG_OK;
    if (image.profile_tag) {
        image.icc_profile.assign(profile.profile, profile.profile_len);
    }
    image.primaries_tag = spng_get_chrm_int(context, &primaries) == SPNG_OK;
    read_text(context, image, file);
}

bool is_ascii(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c > 0; });
}

// zlib clears tables for 32 KB of text, which takes longer than compressing a small picture.
// Smaller ones find the same repeats within `bytes`.
void compress_within(spng_ctx* context, std::size_t bytes) {
    constexpr int least = 9, most = 15, usual_memory = 8;
    int window = least;
    while (window < most && std::size_t{1} << window < bytes) {
        ++window;
    }
    check_write(spng_set_option(context, SPNG_IMG_WINDOW_BITS, window));
    check_write(
        spng_set_option(context, SPNG_IMG_MEM_LEVEL, std::max(1, usual_memory - (most - window))));
}

int append_to(spng_ctx*, void* to, void* bytes, std::size_t length) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), length);
    return SPNG_OK;
}

// Text beyond ASCII is taken as UTF-8, which only iTXt can say.
void set_text(spng_ctx* context, const PngTags& image) {
    std::vector<spng_text> chunks;
    std::string empty;
    for (const auto& [key, value] : image.text) {
        if (key.empty() || key.size() >= sizeof(spng_text::keyword)) {
            throw Error("a PNG text key has 1 to 79 characters", {{}, 0, key});
        }
        if (value.empty()) {
            continue; // libspng refuses it
        }
        spng_text chunk{};
        std::copy(key.begin(), key.end(), chunk.keyword);
        // Cut at a NUL, which the format reserves.
        chunk.length = std::min(value.find('\0'), value.size());
        chunk.text = const_cast<char*>(value.c_str());
        chunk.type = is_ascii(value) ? SPNG_TEXT : SPNG_ITXT;
        chunk.language_tag = empty.data();
        chunk.translated_keyword = empty.data();
        chunks.push_back(chunk);
    }
    if (!chunks.empty()) {
        check_write(
            spng_set_text(context, chunks.data(), static_cast<std::uint32_t>(chunks.size())));
    }
}

} // namespace

bool is_png(std::string_view bytes) {
    return bytes.substr(0, signature.size()) == signature;
}

std::vector<PngChunk> kept_chunks(std::string_view png) {
    constexpr std::array<std::string_view, 7> color{"sRGB", "gAMA", "cHRM", "iCCP",
                                                    "cICP", "mDCV", "cLLI"};
    constexpr std::array<std::string_view, 6> other{"tEXt", "zTXt", "iTXt", "eXIf", "pHYs", "tIME"};
    constexpr std::size_t frame = 12; // length, name, check sum
    std::vector<PngChunk> out;
    for (std::size_t at = signature.size(); at + frame <= png.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            length = length << 8 | static_cast<unsigned char>(png[at + i]);
        }
        if (length > png.size() - at - frame) {
            break;
        }
        const std::string_view name = png.substr(at + 4, 4);
        const bool about_color = std::find(color.begin(), color.end(), name) != color.end();
        if (about_color || std::find(other.begin(), other.end(), name) != other.end()) {
            out.push_back({std::string(png.substr(at, length + frame)), about_color});
        }
        at += length + frame;
    }
    return out;
}

PngPicture read_png_picture(std::string_view bytes, const std::string& file, bool partial) {
    if (!is_png(bytes)) {
        throw Error("this is not a PNG file", {file, 0, {}});
    }
    const Context context = open_context(0);
    check_read(spng_set_chunk_limits(context.get(), max_chunk_bytes, max_chunks_bytes), file);
    check_read(spng_set_png_buffer(context.get(), bytes.data(), bytes.size()), file);
    spng_ihdr header{};
    check_read(spng_get_ihdr(context.get(), &header), file);
    check_size(header.width, header.height, file);
    if (stored_bytes(header) / best_deflate_ratio > bytes.size()) {
        throw Error("the PNG file is cut short; fetch or export it again", {file, 0, {}});
    }

    PngPicture image;
    image.width = static_cast<int>(header.width);
    image.height = static_cast<int>(header.height);
    image.bits = header.bit_depth == 16 ? 16 : 8;
    image.interlaced = header.interlace_method != SPNG_INTERLACE_NONE;
    image.palette = header.color_type == SPNG_COLOR_TYPE_INDEXED;
    image.grey = header.color_type == SPNG_COLOR_TYPE_GRAYSCALE ||
                 header.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA;
    spng_trns transparency{};
    const bool alpha = header.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA ||
                       header.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA ||
                       spng_get_trns(context.get(), &transparency) == SPNG_OK;
    image.channels = alpha ? 4 : 3;

    const bool is_stored_so =
        !alpha && header.bit_depth == 16 && header.color_type == SPNG_COLOR_TYPE_TRUECOLOR;
    const int format = is_stored_so       ? SPNG_FMT_PNG
                       : image.bits == 16 ? SPNG_FMT_RGBA16
                       : alpha            ? SPNG_FMT_RGBA8
                                          : SPNG_FMT_RGB8;
    std::size_t length = 0;
    check_read(spng_decoded_image_size(context.get(), format, &length), file);
    image.samples = SampleBuffer(length);
    const int flags = alpha ? SPNG_DECODE_TRNS : 0;
    if (partial) { // damaged pixels leave libspng without what came before them
        read_tags(context.get(), image, file);
    }
    if (partial && !image.interlaced) {
        image.missing_rows = decode_rows(context.get(), image, length, format, flags, file);
    } else {
        check_read(spng_decode_image(context.get(), image.samples.data(), length, format, flags),
                   file);
    }
    if (!partial) {
        check_end(context.get(), bytes, file);
    }
    if (format == SPNG_FMT_RGBA16 && !alpha) {
        drop_alpha(image.samples.as<std::uint16_t>());
    }

    if (!partial) {
        read_tags(context.get(), image, file);
    }
    return image;
}

std::string write_png(const PngPicture& image) {
    check_size(static_cast<std::uint64_t>(std::max(image.width, 0)),
               static_cast<std::uint64_t>(std::max(image.height, 0)), {});
    const auto bytes_a_pixel = static_cast<std::size_t>(image.channels * image.bits / 8);
    const std::size_t bytes_a_row = static_cast<std::size_t>(image.width) * bytes_a_pixel;
    const std::size_t length = bytes_a_row * static_cast<std::size_t>(image.height);
    if ((image.channels != 3 && image.channels != 4) || (image.bits != 8 && image.bits != 16) ||
        image.samples.size() < length) {
        throw Error("a PNG picture has 3 or 4 channels of 8 or 16 bits, and one sample for each");
    }

    std::string out;
    const Context context = open_context(SPNG_CTX_ENCODER);
    check_write(spng_set_png_stream(context.get(), append_to, &out));
    spng_ihdr header{};
    header.width = static_cast<std::uint32_t>(image.width);
    header.height = static_cast<std::uint32_t>(image.height);
    header.bit_depth = static_cast<std::uint8_t>(image.bits);
    header.color_type =
        image.channels == 4 ? SPNG_COLOR_TYPE_TRUECOLOR_ALPHA : SPNG_COLOR_TYPE_TRUECOLOR;
    check_write(spng_set_ihdr(context.get(), &header));
    if (image.srgb_tag) {
        constexpr std::uint8_t perceptual = 0;
        check_write(spng_set_srgb(context.get(), perceptual));
    }
    spng_iccp profile{};
    if (!image.icc_profile.empty()) {
        constexpr std::string_view name = "ICC profile";
        std::copy(name.begin(), name.end(), profile.profile_name);
        profile.profile = const_cast<char*>(image.icc_profile.data());
        profile.profile_len = image.icc_profile.size();
        check_write(spng_set_iccp(context.get(), &profile));
    }
    set_text(context.get(), image);
    if (length < least_packed_fast) {
        compress_within(context.get(), length + static_cast<std::size_t>(image.height));
        check_write(spng_encode_image(context.get(), image.samples.data(), length, SPNG_FMT_PNG,
                                      SPNG_ENCODE_FINALIZE));
    } else {
        check_write(spng_encode_chunks(context.get()));
        out +=
            packed_rows({image.samples.data(), bytes_a_row, static_cast<std::size_t>(image.height),
                         bytes_a_pixel, image.bits == 16});
        out += end_chunk;
    }
    // They may stand anywhere between the header and the pixels.
    constexpr std::size_t header_end = signature.size() + 25;
    std::string chunks;
    for (const PngChunk& chunk : image.chunks) {
        chunks += chunk.bytes;
    }
    return out.insert(header_end, chunks);
}

std::size_t pixels_of_png(std::string_view head) {
    constexpr std::size_t width_at = 16, height_at = 20;
    const auto number = [&](std::size_t at) {
        std::size_t out = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            out = out << 8 | static_cast<unsigned char>(head[at + i]);
        }
        return std::min<std::size_t>(out, limits::max_image_side);
    };
    return head.size() < height_at + 4 ? 0 : number(width_at) * number(height_at);
}

PngImage read_png(std::string_view bytes, const std::string& file) {
    PngPicture picture = read_png_picture(bytes, file);
    PngImage out;
    static_cast<PngTags&>(out) = std::move(static_cast<PngTags&>(picture));
    out.width = picture.width;
    out.height = picture.height;
    out.channels = picture.channels;
    out.depth.bits = picture.bits;
    if (picture.bits == 8) {
        const auto codes = picture.samples.as<std::uint8_t>();
        out.samples.assign(codes.begin(), codes.end());
    } else {
        const auto codes = picture.samples.as<std::uint16_t>();
        const std::size_t count = static_cast<std::size_t>(picture.width) *
                                  static_cast<std::size_t>(picture.height) *
                                  static_cast<std::size_t>(picture.channels);
        out.samples.assign(codes.begin(), codes.begin() + static_cast<std::ptrdiff_t>(count));
    }
    return out;
}

std::string write_png(const PngImage& image) {
    PngPicture picture;
    static_cast<PngTags&>(picture) = image;
    picture.width = image.width;
    picture.height = image.height;
    picture.channels = image.channels;
    picture.bits = image.depth.bits;
    const bool is_narrow = image.depth.bits == 8;
    picture.samples = SampleBuffer(image.samples.size() * (is_narrow ? 1 : 2));
    if (is_narrow) {
        const bool fits = std::all_of(image.samples.begin(), image.samples.end(),
                                      [](std::uint16_t code) { return code < 256; });
        if (!fits) {
            throw Error("a code is larger than " + std::to_string(image.depth.maximum()));
        }
        std::transform(image.samples.begin(), image.samples.end(),
                       picture.samples.as<std::uint8_t>().begin(),
                       [](std::uint16_t code) { return static_cast<std::uint8_t>(code); });
    } else {
        std::copy(image.samples.begin(), image.samples.end(),
                  picture.samples.as<std::uint16_t>().begin());
    }
    return write_png(picture);
}

} // namespace lutlib::io
