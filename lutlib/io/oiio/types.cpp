#include "lutlib/io/oiio/types.h"

#include "lutlib/error.h"

#include <algorithm>
#include <array>

namespace lutlib::io {
namespace {

using namespace std::string_view_literals;

struct Mark {
    std::string_view type;
    std::string_view bytes;
    std::size_t at = 0;
};

constexpr std::array marks{
    Mark{"openexr", "v/1\x01"sv},
    Mark{"png", "\x89PNG\r\n\x1a\n"sv},
    Mark{"jpeg", "\xff\xd8\xff"sv},
    Mark{"tiff", "II*\0"sv},
    Mark{"tiff", "MM\0*"sv},
    Mark{"tiff", "II+\0"sv}, // BigTIFF
    Mark{"tiff", "MM\0+"sv},
    Mark{"dpx", "SDPX"sv},
    Mark{"dpx", "XPDS"sv},
    Mark{"cineon", "\x80\x2a\x5f\xd7"sv},
    Mark{"cineon", "\xd7\x5f\x2a\x80"sv},
    Mark{"hdr", "#?RADIANCE"sv},
    Mark{"hdr", "#?RGBE"sv},
    Mark{"bmp", "BM"sv},
    Mark{"webp", "WEBP"sv, 8},
    Mark{"gif", "GIF8"sv},
    Mark{"psd", "8BPS"sv},
    Mark{"sgi", "\x01\xda"sv},
    Mark{"jpeg2000", "\0\0\0\x0cjP  \r\n\x87\n"sv},
    Mark{"jpeg2000", "\xff\x4f\xff\x51"sv},
    Mark{"heif", "ftyphei"sv, 4},
    Mark{"heif", "ftypavif"sv, 4},
    Mark{"heif", "ftypmif1"sv, 4},
    Mark{"dds", "DDS "sv},
    Mark{"softimage", "\x53\x80\xf6\x34"sv},
};

// Truevision, "TGA File Format Specification" 2.0: no mark at the beginning, but few values are
// allowed there.
bool is_targa(std::string_view head) {
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

bool is_anymap(std::string_view head) {
    return head.size() > 2 && head[0] == 'P' &&
           "123456Ff"sv.find(head[1]) != std::string_view::npos &&
           " \t\r\n#"sv.find(head[2]) != std::string_view::npos;
}

// Of Maya's IFF, whose reader writes beyond its memory on damaged files.
bool is_iff(std::string_view head) {
    const std::string_view group = head.substr(0, 4);
    return group == "FOR4" || group == "FOR8" || group == "FORM";
}

constexpr std::array<std::string_view, 2> unmarked{"pnm", "targa"};

} // namespace

bool is_known_type(std::string_view type) {
    return std::find(unmarked.begin(), unmarked.end(), type) != unmarked.end() ||
           std::any_of(marks.begin(), marks.end(),
                       [&](const Mark& mark) { return mark.type == type; });
}

std::string_view type_of_bytes(std::string_view head, const std::string& file) {
    const auto* const found = std::find_if(marks.begin(), marks.end(), [&](const Mark& mark) {
        return head.size() >= mark.at && head.substr(mark.at).starts_with(mark.bytes);
    });
    if (found != marks.end()) {
        return found->type;
    }
    if (is_anymap(head)) {
        return "pnm";
    }
    if (is_iff(head)) {
        throw Error("IFF pictures are not read, as no safe reader is at hand; save it as PNG, TIFF "
                    "or EXR",
                    {file, 0, {}});
    }
    if (is_targa(head)) {
        return "targa";
    }
    throw Error("this is no picture of a type that is read; save it as PNG, TIFF or EXR",
                {file, 0, {}});
}

} // namespace lutlib::io
