#include "lutlib/io/recipe_file.h"

#include "lutlib/formats/all.h"

#include "lutlib/io/file.h"

#include <filesystem>
#include <system_error>

namespace lutlib::io {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const std::string& path) {
    return path == standard_stream ? fs::path() : fs::path(path).parent_path();
}

} // namespace

bool is_recipe(std::string_view bytes) {
    const std::string_view bom = "\xef\xbb\xbf";
    if (bytes.starts_with(bom)) {
        bytes.remove_prefix(bom.size());
    }
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first == bytes.npos || bytes[first] != '{') {
        return false;
    }
    // Rich text begins alike, and so does another format of JSON.
    const std::string_view head = bytes.substr(first, 4096);
    return !head.starts_with("{\\rtf") && head.find(formats::azasset.magic) == head.npos;
}

std::string base_path(const Recipe& recipe, const std::string& recipe_path) {
    return recipe.base.empty() ? std::string()
                               : (folder_of(recipe_path) / recipe.base).lexically_normal().string();
}

void save_recipe(Recipe recipe, const std::string& path, const std::string& base_path) {
    recipe.base.clear();
    if (!base_path.empty()) {
        std::error_code unrelated;
        const fs::path folder = fs::absolute(folder_of(path).empty() ? "." : folder_of(path));
        const fs::path relative = fs::proximate(fs::absolute(base_path), folder, unrelated);
        recipe.base = (unrelated ? fs::absolute(base_path) : relative).generic_string();
    }
    write_file(path, to_json(recipe));
}

} // namespace lutlib::io
