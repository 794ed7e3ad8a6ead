// Recipes as files: knowing one, and saving one beside its base LUT.
#pragma once

#include "lutlib/recipe/recipe.h"

#include <string>
#include <string_view>

namespace lutlib::io {

/// Whether bytes begin as a recipe (a JSON object) does, and no LUT format.
bool is_recipe(std::string_view bytes);

/// The bytes of the recipe's file at `path`; `base_path`, where its base lies now, is written
/// relative to that file's folder. Throws Error where JSON cannot hold the name of the base.
std::string recipe_text(Recipe recipe, const std::string& path, const std::string& base_path);
/// Writes them. Throws Error.
void save_recipe(const Recipe& recipe, const std::string& path, const std::string& base_path);

/// Whether who opens such a file must allow its base to lie outside its folder (references.h).
bool has_base_outside(const std::string& path, const std::string& base_path);

/// Where a base that a recipe at `recipe_path` names lies.
std::string base_path(const Recipe& recipe, const std::string& recipe_path);

/// The same of the file at `recipe_path`, as far as can be known; empty: it names none, is no
/// recipe, or cannot be read.
std::string base_named_in(const std::string& recipe_path);

} // namespace lutlib::io
