#include "lutlib/io/picture_types.h"

#include "lutlib/error.h"
#include "lutlib/io/extension.h"

#include <algorithm>

namespace lutlib::io {
namespace {

using namespace std::string_view_literals;

// Truevision, "TGA File Format Specification" 2.0: no mark at the beginning, but few values are
// allowed there.
bool may_be_targa(std::string_view head) {
    if (head.size() < 18) {
        return false;
    }
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(head[at]); };
    constexpr std::array kinds{1, 2, 3, 9, 10, 11};
    constexpr std::array depths{8, 15, 16, 24, 32};
    const auto is_among = [](const auto& all, int value) {
        return std::find(all.begin(), all.end(), value) != all.end();
    };
    return byte(1) <= 1 && is_among(kinds, byte(2)) && is_among(depths, byte(16));
}

bool may_be_anymap(std::string_view head) {
    return head.size() > 2 && head[0] == 'P' &&
           "123456Ff"sv.find(head[1]) != std::string_view::npos &&
           " \t\r\n#"sv.find(head[2]) != std::string_view::npos;
}

// Its first chunk of pixels tells.
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

constexpr auto picture_type_rows = std::to_array<PictureType>({
    {.name = "PNG", .reader = "png", .extensions = {"png"}, .marks = {{{"\x89PNG\r\n\x1a\n"sv}}}},
    {.name = "TIFF",
     .reader = "tiff",
     .extensions = {"tif", "tiff"},
     .marks = {{{"II*\0"sv}, {"MM\0*"sv}, {"II+\0"sv}, {"MM\0+"sv}}}}, // BigTIFF the last two
    {.name = "JPEG",
     .reader = "jpeg",
     .extensions = {"jpg", "jpeg"},
     .marks = {{{"\xff\xd8\xff"sv}}},
     .harm = "JPEG compresses with losses, so its codes are only near those that were saved; save "
             "the look as PNG"},
    {.name = "EXR", .reader = "openexr", .extensions = {"exr", "sxr"}, .marks = {{{"v/1\x01"sv}}}},
    {.name = "DPX", .reader = "dpx", .extensions = {"dpx"}, .marks = {{{"SDPX"sv}, {"XPDS"sv}}}},
    {.name = "Cineon",
     .reader = "cineon",
     .extensions = {"cin"},
     .marks = {{{"\x80\x2a\x5f\xd7"sv}, {"\xd7\x5f\x2a\x80"sv}}}},
    {.name = "WebP",
     .reader = "webp",
     .extensions = {"webp"},
     .marks = {{{"WEBP"sv, 8}}},
     .harm = "this WebP is compressed with losses, so its codes are only near those that were "
             "saved; save the look as PNG",
     .harms = is_lossy_webp},
    {.name = "GIF",
     .reader = "gif",
     .extensions = {"gif"},
     .marks = {{{"GIF8"sv}}},
     .harm = "GIF keeps 256 colours at most, so its codes are only near those that were saved; "
             "save the look as PNG"},
    {.name = "Radiance HDR",
     .reader = "hdr",
     .extensions = {"hdr"},
     .marks = {{{"#?RADIANCE"sv}, {"#?RGBE"sv}}},
     .harm = "Radiance HDR keeps 8 bits a channel of the brightest, so its codes are only near "
             "those that were saved; save the look as PNG or EXR"},
    {.name = "BMP", .reader = "bmp", .extensions = {"bmp"}, .marks = {{{"BM"sv}}}},
    {.name = "PSD", .reader = "psd", .extensions = {"psd"}, .marks = {{{"8BPS"sv}}}},
    {.name = "SGI",
     .reader = "sgi",
     .extensions = {"sgi", "rgb"},
     .marks = {{{"\x01\xda\0\1"sv}, {"\x01\xda\1\1"sv}, {"\x01\xda\0\2"sv}, {"\x01\xda\1\2"sv}}}},
    {.name = "JPEG 2000",
     .reader = "jpeg2000",
     .extensions = {"jp2"},
     .marks = {{{"\0\0\0\x0cjP  \r\n\x87\n"sv}, {"\xff\x4f\xff\x51"sv}}},
     .harm = "JPEG 2000 mostly compresses with losses, so its codes may be only near those that "
             "were saved; save the look as PNG"},
    {.name = "HEIF or AVIF",
     .reader = "heif",
     .extensions = {"heic", "avif"},
     .marks = {{{"ftyphei"sv, 4}, {"ftypavif"sv, 4}, {"ftypmif1"sv, 4}}},
     .harm = "HEIF and AVIF mostly compress with losses, so their codes may be only near those "
             "that were saved; save the look as PNG"},
    {.name = "DDS",
     .reader = "dds",
     .extensions = {"dds"},
     .marks = {{{"DDS "sv}}},
     .harm = "DDS mostly compresses with losses, so its codes may be only near those that were "
             "saved; save the look as PNG"},
    {.name = "Softimage",
     .reader = "softimage",
     .extensions = {"pic"},
     .marks = {{{"\x53\x80\xf6\x34"sv}}}},
    {.name = "PPM",
     .reader = "pnm",
     .extensions = {"ppm", "pgm", "pnm", "pfm"},
     .marks = {{{"P6\n"sv}, {"P5\n"sv}, {"PF\n"sv}, {"Pf\n"sv}}},
     .may_be = may_be_anymap},
    {.name = "TGA", .reader = "targa", .extensions = {"tga"}, .may_be = may_be_targa},
});

template <class Holds>
const PictureType* first_that(Holds&& holds) {
    const auto* const row = std::find_if(picture_type_rows.begin(), picture_type_rows.end(), holds);
    return row == picture_type_rows.end() ? nullptr : &*row;
}

// The row with a mark of at least `shortest` bytes.
const PictureType* marked(std::string_view bytes, std::size_t shortest) {
    return first_that([&](const PictureType& type) {
        return std::any_of(type.marks.begin(), type.marks.end(), [&](const auto& mark) {
            return !mark.bytes.empty() && mark.bytes.size() >= shortest &&
                   bytes.size() >= mark.at && bytes.substr(mark.at).starts_with(mark.bytes);
        });
    });
}

// Of Maya's IFF, whose reader in OpenImageIO writes beyond its memory on damaged files.
bool is_iff(std::string_view head) {
    const std::string_view group = head.substr(0, 4);
    return group == "FOR4" || group == "FOR8" || group == "FORM";
}

} // namespace

std::span<const PictureType> picture_types() {
    return picture_type_rows;
}

const PictureType* picture_type_of(std::string_view bytes, std::string_view file) {
    const PictureType* const begun = marked(bytes, 1);
    const std::string extension = extension_of(file);
    return begun ? begun : first_that([&](const PictureType& type) {
        return type.extensions.contain(extension);
    });
}

bool begins_as_picture(std::string_view bytes) {
    constexpr std::size_t unlikely_in_text = 3;
    return marked(bytes, unlikely_in_text) != nullptr;
}

bool is_picture_extension(std::string_view extension) {
    return first_that([&](const PictureType& type) { return type.extensions.contain(extension); });
}

std::string_view reader_of(std::string_view head, const std::string& file) {
    if (const PictureType* const type = marked(head, 1)) {
        return type->reader;
    }
    if (is_iff(head)) {
        throw Error("IFF pictures are not read, as no safe reader is at hand; save it as PNG, TIFF "
                    "or EXR",
                    {file, 0, {}});
    }
    if (const PictureType* const type =
            first_that([&](const PictureType& row) { return row.may_be && row.may_be(head); })) {
        return type->reader;
    }
    throw Error("this is no picture of a type that is read; save it as PNG, TIFF or EXR",
                {file, 0, {}});
}

bool is_read_by(std::string_view reader) {
    return first_that([&](const PictureType& type) { return type.reader == reader; });
}

} // namespace lutlib::io
