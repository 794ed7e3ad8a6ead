#include "preview/scene/import.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/references.h"
#include "preview/scene/import_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <span>

namespace preview {

namespace {

constexpr std::string_view own_models[] = {"gltf", "glb", "obj"};
constexpr std::string_view other_models[] = {"3ds", "abc", "blend", "dae",  "dxf",  "fbx",  "lwo",
                                             "ply", "stl", "usd",   "usda", "usdc", "usdz", "x3d"};

bool is_one_of(std::span<const std::string_view> endings, std::string_view ending) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// Pipes and devices would be waited for, or never end.
std::string model_bytes(const std::string& path) {
    std::error_code failed;
    if (std::filesystem::exists(path, failed) && !std::filesystem::is_regular_file(path, failed)) {
        throw lutlib::Error("a model must be a file", {path, 0, {}});
    }
    return lutlib::io::read_file(path, import_limits.file_bytes);
}

} // namespace

std::vector<std::string> LeftOut::lines() const {
    std::vector<std::string> lines;
    for (const auto& [what, count] : counts_) {
        lines.push_back(fmt::format("{} {}", count, what));
    }
    return lines;
}

bool is_model_file(const std::string& path) {
    const std::string extension = lutlib::io::extension_of(path);
    return is_one_of(own_models, extension) || is_one_of(other_models, extension);
}

ImportedScene import_scene(const std::string& path) {
    if (is_one_of(other_models, lutlib::io::extension_of(path))) {
        throw lutlib::Error("models of this type are not read; save it as glTF 2.0 (.glb)",
                            {path, 0, {}});
    }
    const std::string bytes = model_bytes(path);
    std::vector<std::string> files{path};
    const ReadFile read = [&](const std::string& reference, std::size_t most) {
        const std::string named = lutlib::io::referenced_path(path, reference);
        // Nobody shall look where a model may not lead.
        const bool is_within = !lutlib::io::leads_outside(path, reference);
        if (is_within) {
            files.push_back(named);
        }
        std::string text = lutlib::io::read_reference(path, reference, most);
        if (!is_within) {
            files.push_back(named);
        }
        return text;
    };
    ImportedScene out;
    if (lutlib::io::extension_of(path) != "obj") {
        out = import_gltf(bytes, path, read);
    } else {
        LeftOut left_out;
        out.scene = settled(obj_scene(bytes, path, read, left_out), path, left_out);
        out.left_out = left_out.lines();
    }
    out.files = std::move(files);
    return out;
}

} // namespace preview
