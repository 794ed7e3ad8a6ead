#include "preview/scene/gltf_file.h"

#include "lutlib/error.h"
#include "lutlib/json_text.h"
#include "preview/scene/import_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace preview {

namespace {

using nlohmann::json;

constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;
constexpr std::uint32_t json_chunk = 0x4E4F534A, body_chunk = 0x004E4942;

std::uint32_t word(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// The chunk at `at`, if it is whole and of that type.
std::optional<std::string_view> chunk(std::string_view bytes, std::size_t at, std::uint32_t type) {
    if (at > bytes.size() || bytes.size() - at < chunk_header_bytes ||
        word(bytes, at + 4) != type || word(bytes, at) > bytes.size() - at - chunk_header_bytes) {
        return std::nullopt;
    }
    return bytes.substr(at + chunk_header_bytes, word(bytes, at));
}

/// Before it is parsed: the library's own callback looks at a whole list for each of its objects.
/// Calls `refuse`, which throws, for JSON beyond the limits.
void check_bounds(std::string_view text, const auto& refuse) {
    int depth = 0;
    std::size_t values = 1;
    bool is_quoted = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (is_quoted && c == '\\') {
            ++at;
        } else if (c == '"') {
            is_quoted = !is_quoted;
        } else if (!is_quoted) {
            const bool opens = c == '[' || c == '{';
            depth += opens ? 1 : c == ']' || c == '}' ? -1 : 0;
            values += opens || c == ',' ? 1 : 0;
        }
        if (depth > import_limits.depth) {
            refuse("its JSON is nested too deeply");
        }
        if (values > import_limits.json_values) {
            refuse(fmt::format("its JSON holds more than {} values, which is the limit",
                               import_limits.json_values));
        }
    }
}

} // namespace

GltfFile::GltfFile(std::string_view bytes, std::string path, ReadFile read)
    : path_(std::move(path)), read_(std::move(read)), is_binary_(bytes.starts_with("glTF")) {
    if (is_binary_) {
        if (bytes.size() >= header_bytes && word(bytes, 4) != 2) {
            refuse(fmt::format("it is glTF {}; convert it to glTF 2.0", word(bytes, 4)));
        }
        const auto text = chunk(bytes, header_bytes, json_chunk);
        if (!text) {
            refuse("not a binary glTF file, or cut short");
        }
        const std::size_t end = header_bytes + chunk_header_bytes + text->size();
        body_ = chunk(bytes, end, body_chunk).value_or(std::string_view{});
        bytes = *text;
    }
    check_bounds(bytes, [&](const std::string& why) { refuse(why); });
    try {
        root_ = json::parse(bytes);
    } catch (const json::exception& error) {
        refuse("not a glTF file: its JSON cannot be read: " +
               printable(lutlib::json_reason(error)));
    }
    const std::string version = root_.is_object() && root_.contains("asset")
                                    ? gltf_text(root_["asset"], "version")
                                    : std::string();
    if (version.empty()) {
        refuse("not a glTF file: asset.version is missing");
    }
    if (!version.starts_with("2.")) {
        refuse("it is glTF " + printable(version) + "; convert it to glTF 2.0");
    }
    for (const char* key : {"accessors", "bufferViews", "buffers", "cameras", "images", "materials",
                            "meshes", "nodes", "samplers", "scenes", "skins", "textures"}) {
        list(root_, key);
    }
    buffers_.resize(list("buffers").size());
}

void GltfFile::refuse(const std::string& message, const std::string& text) const {
    throw lutlib::Error(message, {path_, 0, text});
}

const json& GltfFile::list(const json& object, const char* key) const {
    static const json none = json::array();
    const auto found = object.find(key);
    if (found == object.end()) {
        return none;
    }
    if (!found->is_array()) {
        refuse(fmt::format("'{}' is not a list", key));
    }
    for (const json& row : *found) {
        if (!row.is_object()) {
            refuse(fmt::format("'{}' holds something that is not an object", key));
        }
    }
    return *found;
}

const json& GltfFile::list(const char* key) const {
    static const json none = json::array();
    const auto found = root_.find(key);
    return found != root_.end() ? *found : none;
}

void GltfFile::spend(std::size_t elements) const {
    spent_ += std::min(elements, import_limits.elements + 1);
    if (spent_ > import_limits.elements) {
        refuse(fmt::format("its accessors hold more than {} elements, which is the limit",
                           import_limits.elements));
    }
}

std::size_t GltfFile::count(const json& object, const char* key, std::size_t usual) const {
    const auto found = object.find(key);
    if (found == object.end()) {
        return usual;
    }
    if (!found->is_number_unsigned()) {
        refuse(fmt::format("'{}' is not a valid count or index", key), found->dump().substr(0, 80));
    }
    return found->get<std::size_t>();
}

std::optional<std::size_t> GltfFile::index(const json& object, const char* key,
                                           const char* rows) const {
    if (!object.contains(key)) {
        return std::nullopt;
    }
    const std::size_t at = count(object, key, 0);
    if (at >= list(rows).size()) {
        refuse(fmt::format("'{}' names something that does not exist", key), std::to_string(at));
    }
    return at;
}

float gltf_number(const json& object, const char* key, float usual) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) {
        return usual;
    }
    const auto value = found->get<float>();
    return std::isfinite(value) ? value : usual;
}

bool gltf_numbers(const json& object, const char* key, float* to, std::size_t count) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_array() || found->size() != count) {
        return false;
    }
    std::vector<float> values;
    for (const json& value : *found) {
        if (!value.is_number() || !std::isfinite(value.get<float>())) {
            return false;
        }
        values.push_back(value.get<float>());
    }
    std::copy(values.begin(), values.end(), to);
    return true;
}

const json& gltf_object(const json& object, const char* key) {
    static const json none = json::object();
    const auto found = object.find(key);
    return found != object.end() && found->is_object() ? *found : none;
}

std::string gltf_text(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

} // namespace preview
