#include "preview/scene/gltf_file.h"

#include "lutlib/error.h"

#include <fmt/format.h>

#include <cstring>
#include <string_view>

namespace preview {

namespace {

using lutlib::Error;
using nlohmann::json;

constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;
constexpr std::uint32_t json_chunk = 0x4E4F534A, body_chunk = 0x004E4942;

std::uint32_t word(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

void append(std::string& bytes, std::size_t value) {
    const auto small = static_cast<std::uint32_t>(value);
    bytes.append(reinterpret_cast<const char*>(&small), sizeof small);
}

json parsed(std::string_view text, const std::string& path) {
    const auto limit_depth = [&](int depth, json::parse_event_t, json&) {
        if (depth > import_limits.depth) {
            throw Error("its JSON is nested too deeply", {path, 0, {}});
        }
        return true;
    };
    try {
        return json::parse(text, limit_depth);
    } catch (const json::exception& error) {
        throw Error(fmt::format("not a glTF file: its JSON cannot be read: {}", error.what()),
                    {path, 0, {}});
    }
}

void check_version(const json& root, const std::string& path) {
    const json::json_pointer at("/asset/version");
    if (!root.is_object() || !root.contains(at) || !root[at].is_string()) {
        throw Error("not a glTF file: asset.version is missing", {path, 0, {}});
    }
    const std::string version = root[at].get<std::string>();
    if (version.compare(0, 2, "2.") != 0) {
        throw Error("it is glTF " + version + "; convert it to glTF 2.0", {path, 0, {}});
    }
}

} // namespace

GltfFile::GltfFile(const std::string& bytes, const std::string& path)
    : is_binary(bytes.compare(0, 4, "glTF") == 0) {
    std::string_view text = bytes;
    if (is_binary) {
        constexpr std::size_t start = header_bytes + chunk_header_bytes;
        const bool has_json = bytes.size() >= start && word(bytes, 16) == json_chunk &&
                              word(bytes, 12) <= bytes.size() - start;
        if (!has_json) {
            throw Error("not a binary glTF file, or cut short", {path, 0, {}});
        }
        text = std::string_view(bytes).substr(start, word(bytes, 12));
        body = bytes.substr(start + text.size());
    }
    root = parsed(text, path);
    check_version(root, path);
}

std::string GltfFile::to_bytes() const {
    std::string text = root.dump(-1, ' ', false, json::error_handler_t::replace);
    if (!is_binary) {
        return text;
    }
    text.append((4 - text.size() % 4) % 4, ' ');
    std::string bytes = "glTF";
    append(bytes, 2);
    append(bytes, header_bytes + chunk_header_bytes + text.size() + body.size());
    append(bytes, text.size());
    append(bytes, json_chunk);
    return bytes + text + body;
}

std::size_t GltfFile::body_bytes() const {
    if (body.size() < chunk_header_bytes || word(body, 4) != body_chunk) {
        return 0;
    }
    const std::size_t length = word(body, 0);
    return length <= body.size() - chunk_header_bytes ? length : 0;
}

const json& gltf_list(const json& object, const char* key, const std::string& path) {
    static const json none = json::array();
    const auto found = object.find(key);
    if (found == object.end()) {
        return none;
    }
    if (!found->is_array()) {
        throw Error(fmt::format("'{}' is not a list", key), {path, 0, {}});
    }
    for (const json& row : *found) {
        if (!row.is_object()) {
            throw Error(fmt::format("'{}' holds something that is not an object", key),
                        {path, 0, {}});
        }
    }
    return *found;
}

} // namespace preview
