// A glTF 2.0 file as JSON and bytes, of which everything that is asked is checked when it is asked.
//
// A .gltf is JSON. A .glb is the word "glTF", a version and the whole length, then chunks of a
// length, a type and that many bytes: the JSON, then the contents of the first buffer; words are
// little-endian, chunks padded to four bytes.
#pragma once

#include "preview/scene/import.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace preview {

/// Every function throws lutlib::Error, which names the file, for what is broken or beyond
/// import_limits.
class GltfFile {
  public:
    using json = nlohmann::json;

    /// `bytes` of the file at `path`; what it names is read by `read` when it is needed.
    GltfFile(std::string_view bytes, std::string path, ReadFile read);

    const json& root() const { return root_; }
    const std::string& path() const { return path_; }
    [[noreturn]] void refuse(const std::string& message, const std::string& text = {}) const;

    /// A list of objects, or an empty one where there is none.
    const json& list(const json& object, const char* key) const;
    /// The same of the root, checked once.
    const json& list(const char* key) const;
    /// The number of the row of the root's list `rows` that the member names, if there is a member.
    std::optional<std::size_t> index(const json& object, const char* key, const char* rows) const;
    /// A count; `usual` where there is none.
    std::size_t count(const json& object, const char* key, std::size_t usual) const;

    /// Refuses the file when what is read of it is more than the limit in all: many meshes may
    /// share few bytes.
    void spend(std::size_t elements) const;
    std::string_view view_bytes(std::size_t view) const;
    /// Of a data URI, or of a file beside this one. URIs may be percent-encoded.
    std::string uri_bytes(const std::string& uri, std::size_t most) const;

  private:
    const std::string& buffer(std::size_t index) const;
    std::string loaded(std::size_t index) const;

    std::string path_;
    ReadFile read_;
    json root_;
    bool is_binary_ = false;
    std::string body_; ///< the chunk after the JSON
    mutable std::vector<std::optional<std::string>> buffers_;
    mutable std::size_t spent_ = 0; ///< elements
};

/// A member that is a number; `usual` where there is none or it is not finite.
float gltf_number(const nlohmann::json& object, const char* key, float usual);
/// `count` numbers; false where there are others or none.
bool gltf_numbers(const nlohmann::json& object, const char* key, float* to, std::size_t count);
/// A member that is an object, or an empty one.
const nlohmann::json& gltf_object(const nlohmann::json& object, const char* key);
std::string gltf_text(const nlohmann::json& object, const char* key);

/// An accessor's elements as floats, `components` each, whole numbers as they are or, if the
/// accessor is normalized, over 0..1 or -1..1. Refuses accessors of other shapes.
std::vector<float> gltf_floats(const GltfFile& file, std::size_t accessor, std::size_t components);
/// Whole numbers, `components` an element.
std::vector<std::uint32_t> gltf_words(const GltfFile& file, std::size_t accessor,
                                      std::size_t components);
/// Components of the accessor's type: 1, 2, 3, 4, 9 or 16.
std::size_t gltf_components(const GltfFile& file, std::size_t accessor);

} // namespace preview
