// Buffers of a glTF file, and what URIs name.
#include "preview/scene/gltf_file.h"

#include "lutlib/error.h"
#include "preview/scene/import_parts.h"

#include <fmt/format.h>

#include <array>

namespace preview {

namespace {

int hex_digit(char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

/// RFC 3986, 2.1: %20 is a blank.
std::string percent_decoded(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const int high = at + 2 < text.size() && text[at] == '%' ? hex_digit(text[at + 1]) : -1;
        const int low = high >= 0 ? hex_digit(text[at + 2]) : -1;
        if (low >= 0) {
            out += static_cast<char>(high * 16 + low);
            at += 2;
        } else {
            out += text[at];
        }
    }
    return out;
}

constexpr std::array<std::int8_t, 256> make_base64_values() {
    std::array<std::int8_t, 256> values{};
    values.fill(-1);
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < digits.size(); ++i) {
        values[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
    }
    return values;
}

/// RFC 4648; nothing for what is no base64.
std::optional<std::string> base64_decoded(std::string_view text) {
    static constexpr auto values = make_base64_values();
    std::string out;
    out.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        if (c == '=') {
            break;
        }
        const int value = values[static_cast<unsigned char>(c)];
        if (value < 0) {
            return std::nullopt;
        }
        bits = bits << 6U | static_cast<std::uint32_t>(value);
        held += 6;
        if (held >= 8) {
            held -= 8;
            out += static_cast<char>(bits >> static_cast<unsigned>(held) & 255U);
        }
    }
    return out;
}

/// A scheme of two letters or more: "http:", "file:".
bool has_scheme(std::string_view uri) {
    const std::size_t colon = uri.find_first_of(":/?#");
    return colon != std::string_view::npos && colon > 1 && uri[colon] == ':';
}

} // namespace

std::string GltfFile::uri_bytes(const std::string& uri, std::size_t most) const {
    if (uri.starts_with("data:")) {
        constexpr std::string_view mark = ";base64,";
        const std::size_t at = uri.find(mark);
        auto bytes = at == std::string::npos
                         ? std::nullopt
                         : base64_decoded(std::string_view(uri).substr(at + mark.size()));
        if (!bytes) {
            refuse("a data URI is not base64", uri.substr(0, 60));
        }
        return std::move(*bytes);
    }
    if (has_scheme(uri)) {
        refuse("a URI names nothing beside the file; only files and data URIs are read",
               uri.substr(0, 60));
    }
    return read_(percent_decoded(uri), most);
}

std::string GltfFile::loaded(std::size_t index) const {
    const json& row = list("buffers")[index];
    const std::size_t length = count(row, "byteLength", 0);
    if (length > import_limits.file_bytes) {
        refuse("a buffer is larger than the limit");
    }
    const bool is_beside = row.contains("uri");
    if (!is_beside && (!is_binary_ || index != 0)) {
        refuse("a buffer has no uri");
    }
    std::string bytes;
    try {
        bytes = is_beside ? uri_bytes(gltf_text(row, "uri"), import_limits.file_bytes) : body_;
    } catch (const lutlib::Error& error) {
        throw lutlib::Error(std::string("a buffer: ") + error.what(), {path_, 0, {}});
    }
    if (bytes.size() < length) {
        refuse(fmt::format("a buffer has {} bytes, not the {} that it should have", bytes.size(),
                           length));
    }
    bytes.resize(length);
    return bytes;
}

const std::string& GltfFile::buffer(std::size_t index) const {
    std::optional<std::string>& bytes = buffers_[index];
    if (!bytes) {
        bytes = loaded(index);
    }
    return *bytes;
}

std::string_view GltfFile::view_bytes(std::size_t view) const {
    const json& row = list("bufferViews")[view];
    const auto at = index(row, "buffer", "buffers");
    if (!at) {
        refuse("a bufferView names no buffer");
    }
    const std::size_t length = count(row, "byteLength", 0);
    const std::size_t offset = count(row, "byteOffset", 0);
    const std::size_t whole = count(list("buffers")[*at], "byteLength", 0);
    if (length > whole || offset > whole - length) {
        refuse("a bufferView reaches beyond its buffer");
    }
    return std::string_view(buffer(*at)).substr(offset, length);
}

} // namespace preview
