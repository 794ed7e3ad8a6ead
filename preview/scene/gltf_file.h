// A glTF file as JSON and what follows it, before a parser of scenes gets it.
//
// A .gltf is JSON. A .glb is the word "glTF", a version and the whole length, then chunks of a
// length, a type and that many bytes: the JSON, then the contents of the first buffer; words are
// little-endian, chunks padded to four bytes.
#pragma once

#include "preview/scene/import_parts.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace preview {

struct GltfFile {
    nlohmann::json root;
    bool is_binary = false;
    std::string body; ///< chunks of a .glb after the JSON, with their headers

    /// Throws lutlib::Error for what is no glTF 2.0.
    GltfFile(const std::string& bytes, const std::string& path);
    /// As bytes that the constructor would take.
    std::string to_bytes() const;
    /// Of the first buffer in a .glb.
    std::size_t body_bytes() const;
};

/// Refuses what a parser should not be trusted with: types that are none, cycles and depth of
/// nodes, ranges beyond their buffers, counts beyond import_limits. Throws lutlib::Error.
void check_gltf(const GltfFile& file, const std::string& path);

/// Leaves in the JSON only what this import takes over, and counts the rest.
void reduce_gltf(nlohmann::json& root, LeftOut& left_out);

GltfFacts facts_of(const nlohmann::json& root);

/// An array of objects, or nothing. Throws lutlib::Error for anything else.
const nlohmann::json& gltf_list(const nlohmann::json& object, const char* key,
                                const std::string& path);

} // namespace preview
