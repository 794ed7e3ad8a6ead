// Recipes as files: knowing one, and saving one beside its base LUT.
#pragma once

#include "lutlib/recipe/recipe.h"

#include <string>
#include <string_view>

namespace lutlib::io {

/// Whether bytes begin as a recipe (a JSON object) does, and no LUT format.
bool is_recipe(std::string_view bytes);

/// Writes the recipe; `base_path`, where its base lies now, is written relative to the recipe's
/// folder. Throws Error.
void save_recipe(Recipe recipe, const std::string& path, const std::string& base_path);

/// Where a base that a recipe at `recipe_path` names lies.
std::string base_path(const Recipe& recipe, const std::string& recipe_path);

} // namespace lutlib::io
