// Recipes as files: reading one with its base LUT, and saving one beside it.
#pragma once

#include "lutlib/recipe/recipe.h"

#include <functional>
#include <string>
#include <string_view>

namespace lutlib::io {

/// Reads the LUT at a path; each program knows which formats it has.
using LutReader = std::function<Lut(const std::string& path)>;

/// Whether bytes begin as a recipe (a JSON object) does, and no LUT format.
bool is_recipe(std::string_view bytes);

/// Parses a recipe and reads its base, whose path is relative to the recipe's folder. Throws Error.
Recipe read_recipe(const std::string& path, const LutReader& read_lut);
/// The same of bytes that have been read from `path`.
Recipe recipe_from(std::string_view bytes, const std::string& path, const LutReader& read_lut);

/// Sets the base: the LUT at `path`, read by `read_lut`.
void set_base(Recipe& recipe, const std::string& path, const LutReader& read_lut);

/// Writes the recipe; `base_path`, where its base lies now, is written relative to the recipe's
/// folder. Throws Error.
void save_recipe(Recipe recipe, const std::string& path, const std::string& base_path);

/// Where a base that a recipe at `recipe_path` names lies.
std::string base_path(const Recipe& recipe, const std::string& recipe_path);

} // namespace lutlib::io
