// The sample looks that the repository carries are what their recipes make.
#include "lutlib/formats/cube.h"
#include "lutlib/recipe/bake_recipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace lutlib {
namespace {

std::string contents(const std::filesystem::path& path) {
    std::ostringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
}

TEST(SampleLooks, are_what_their_recipes_bake_to) {
    std::size_t looks = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SAMPLE_LOOKS)) {
        if (entry.path().extension() != ".json") {
            continue;
        }
        ++looks;
        const Recipe recipe = parse_recipe(contents(entry.path()), entry.path().string());
        EXPECT_EQ(parse_recipe(to_json(recipe), "").operations, recipe.operations);
        const Lut baked = bake_recipe(recipe);
        std::filesystem::path cube = entry.path();
        cube.replace_extension(".cube");
        const Lut file = read_cube(contents(cube), cube.string());
        EXPECT_EQ(file.title, recipe.title);
        ASSERT_EQ(file.shaper.has_value(), baked.shaper.has_value());
        ASSERT_EQ(file.cube->size, baked.cube->size);
        EXPECT_EQ(file.domain(), baked.domain());
        for (std::size_t i = 0; i < file.cube->nodes.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                // Processors with other vectors round the last place of a double differently.
                ASSERT_NEAR(file.cube->nodes[i][c], baked.cube->nodes[i][c], 1e-6) << cube;
            }
        }
    }
    EXPECT_GE(looks, 5U);
}

} // namespace
} // namespace lutlib
