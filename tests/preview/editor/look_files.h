// Look files that change, for tests.
#pragma once

#include "lutlib/recipe/recipe.h"
#include "lutlib/transform.h"
#include "tests/lutlib/io/scratch.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <string>
#include <variant>

namespace preview::editor {

/// A cube of two nodes a side that multiplies by `gain`.
inline std::string cube_of(double gain) {
    std::string out = "LUT_3D_SIZE 2\n";
    for (int node = 0; node < 8; ++node) {
        out += fmt::format("{} {} {}\n", gain * (node & 1), gain * (node >> 1 & 1),
                           gain * (node >> 2));
    }
    return out;
}

inline std::string recipe_of(double stops, const std::string& base = "") {
    return fmt::format(
        R"({{"schema_version": 1,{} "operators": [{{"op": "exposure", "stops": {}}}]}})",
        base.empty() ? "" : fmt::format(R"( "base": "{}",)", base), stops);
}

/// As programs do that write over a file.
inline void overwrite(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// As editors do that write beside a file.
inline void rename_over(const std::string& path, const std::string& text) {
    overwrite(path + "~", text);
    std::filesystem::rename(path + "~", path);
}

/// What the recipe makes of white.
inline double white_of(const lutlib::Recipe& recipe) {
    return lutlib::Transform::of(recipe)({1, 1, 1}).g;
}
inline double white_of(const std::shared_ptr<const lutlib::Lut>& lut) {
    return lutlib::Transform::of(lut)({1, 1, 1}).g;
}
inline double stops_of(const lutlib::Recipe& recipe) {
    return std::get<double>(recipe.operations.at(0).values.at(0));
}

} // namespace preview::editor
