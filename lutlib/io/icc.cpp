#include "lutlib/io/icc.h"

#include "lutlib/text.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace lutlib::io {
namespace {

constexpr std::size_t header_bytes = 128, tag_bytes = 12;

// Big endian; 0 beyond the end.
std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const bool is_there = at + i < bytes.size();
        out = out << 8 | (is_there ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    }
    return out;
}

std::string_view part(std::string_view bytes, std::size_t at, std::size_t size) {
    return at < bytes.size() ? bytes.substr(at, size) : std::string_view{};
}

std::string_view description_tag(std::string_view profile) {
    constexpr std::uint32_t most_tags = 1000;
    const std::uint32_t count = number_at(profile, header_bytes, 4);
    for (std::uint32_t i = 0; i < count && i < most_tags; ++i) {
        const std::size_t at = header_bytes + 4 + tag_bytes * i;
        if (part(profile, at, 4) == "desc") {
            return part(profile, number_at(profile, at + 4, 4), number_at(profile, at + 8, 4));
        }
    }
    return {};
}

struct KnownProfile {
    std::string_view begins, encoding;
};
constexpr std::array<KnownProfile, 4> known{{
    {"SRGB", "srgb"},
    {"DISPLAY P3", "srgb/display-p3"},
    {"ADOBE RGB (1998)", "gamma22/adobe-rgb"},
    {"REC. 709 GAMMA 2.4", "gamma24/rec709"},
}};

} // namespace

std::string icc_description(std::string_view profile) {
    const std::string_view tag = description_tag(profile);
    std::string out;
    if (part(tag, 0, 4) == "desc") {
        out = part(tag, 12, number_at(tag, 8, 4));
    } else if (part(tag, 0, 4) == "mluc") {
        const std::string_view text = part(tag, number_at(tag, 24, 4), number_at(tag, 20, 4));
        for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
            const std::uint32_t code = number_at(text, i, 2);
            out += code < 0x80 ? static_cast<char>(code) : '?';
        }
    }
    return out.substr(0, out.find('\0'));
}

std::optional<Encoding> encoding_of_profile(std::string_view profile) {
    const std::string description = upper(icc_description(profile));
    for (const KnownProfile& row : known) {
        if (std::string_view(description).substr(0, row.begins.size()) == row.begins) {
            return encoding_named(row.encoding);
        }
    }
    return std::nullopt;
}

} // namespace lutlib::io
