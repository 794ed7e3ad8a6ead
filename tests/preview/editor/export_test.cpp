// Strips in an engine's folder: their names, and what is written over without asking.
#include "preview/editor/commands.h"
#include "tests/preview/editor/look_files.h"

#include <gtest/gtest.h>

namespace preview::editor {
namespace {

namespace fs = std::filesystem;
using lutlib::ScratchFolder;

TEST(StripInAFolder, is_named_as_the_look_is) {
    State state = initial_state();
    EXPECT_EQ(strip_in("game", state), "game/look.png");
    state.base_path = "luts/warm teal.v2.cube";
    EXPECT_EQ(strip_in("game/", state), "game/warm teal.v2.png");
    state.recipe_path = "warmer.json";
    EXPECT_EQ(strip_in("/game", state), "/game/warmer.png");
}

TEST(StripInAFolder, is_written_over_strips_of_our_own_and_nothing_else) {
    const ScratchFolder folder;
    State state = initial_state();
    const std::string strip = folder.file("strip.png");
    EXPECT_TRUE(is_replaceable(state, strip));
    const std::string report = export_strip(state, state.sides[0], strip);
    EXPECT_TRUE(report.starts_with("the recipe -> " + strip + "\n")) << report;
    EXPECT_TRUE(is_replaceable(state, strip));
    state.base_path = strip;
    EXPECT_FALSE(is_replaceable(state, strip)) << "the recipe starts from it";
    state.base_path.clear();
    const std::string whole = [&] {
        std::ifstream in(strip, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
    }();
    overwrite(strip, whole.substr(0, whole.size() / 2));
    EXPECT_FALSE(is_replaceable(state, strip)) << "damaged";
    for (const std::string& theirs : {std::string(), std::string("x"), cube_of(1)}) {
        overwrite(strip, theirs);
        EXPECT_FALSE(is_replaceable(state, strip)) << theirs;
    }
    fs::remove(strip);
    fs::create_symlink(folder.file("gone"), strip);
    EXPECT_FALSE(is_replaceable(state, strip)) << "a link that leads nowhere";
    fs::remove(strip);
    fs::create_directory(strip);
    EXPECT_FALSE(is_replaceable(state, strip)) << "a folder";
    EXPECT_FALSE(is_replaceable(state, "/dev/null"));
}

} // namespace
} // namespace preview::editor
