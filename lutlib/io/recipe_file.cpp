#include "lutlib/io/recipe_file.h"

#include "lutlib/error.h"
#include "lutlib/formats/all.h"
#include "lutlib/io/file.h"
#include "lutlib/io/references.h"
#include "lutlib/io/terminal.h"

#include <filesystem>
#include <system_error>

namespace lutlib::io {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const std::string& path) {
    return path == standard_stream ? fs::path() : fs::path(path).parent_path();
}

// Of the base, in the folder of the recipe at `path`.
std::string relative_name(const std::string& path, const std::string& base_path) {
    std::error_code unrelated;
    const fs::path folder = fs::absolute(folder_of(path).empty() ? "." : folder_of(path));
    const fs::path relative = fs::proximate(fs::absolute(base_path), folder, unrelated);
    return (unrelated ? fs::absolute(base_path) : relative).generic_string();
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
    return recipe.base.empty() ? std::string() : referenced_path(recipe_path, recipe.base);
}

std::string recipe_text(Recipe recipe, const std::string& path, const std::string& base_path) {
    recipe.base = base_path.empty() ? std::string() : relative_name(path, base_path);
    if (!is_utf8(recipe.base)) {
        throw Error("a recipe can name its base only in UTF-8; rename that file or its folder",
                    {base_path, 0, {}});
    }
    return to_json(recipe);
}

void save_recipe(const Recipe& recipe, const std::string& path, const std::string& base_path) {
    write_file(path, recipe_text(recipe, path, base_path));
}

bool has_base_outside(const std::string& path, const std::string& base_path) {
    return !base_path.empty() && leads_outside(path, relative_name(path, base_path));
}

std::string base_named_in(const std::string& recipe_path) {
    constexpr std::size_t head_bytes = 4096;
    try {
        const auto head = head_of_regular_file(recipe_path, head_bytes);
        return head && is_recipe(*head)
                   ? base_path(parse_recipe(read_file(recipe_path), recipe_path), recipe_path)
                   : std::string();
    } catch (const Error&) {
        return {};
    }
}

} // namespace lutlib::io
