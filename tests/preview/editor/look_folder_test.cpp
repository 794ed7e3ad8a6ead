// The looks of a folder, and which of them stands beside which.
#include "preview/editor/look_folder.h"

#include "preview/editor/commands.h"
#include "tests/preview/editor/look_files.h"

#include <gtest/gtest.h>

namespace preview::editor {
namespace {

namespace fs = std::filesystem;
using lutlib::ScratchFolder;

std::string path_of(const ScratchFolder& folder) {
    return fs::path(folder.file("x")).parent_path().lexically_normal().string();
}

TEST(LookFolder, has_what_may_be_a_look_by_its_ending_and_no_folders) {
    const ScratchFolder folder;
    for (const char* const name : {"b.cube", "A.json", "c.txt", "d.3dl", ".hidden.cube", "e.png"}) {
        overwrite(folder.file(name), "x");
    }
    fs::create_directory(folder.file("folder.cube"));
    const LookFolder looks = looks_in(path_of(folder));
    EXPECT_EQ(looks.names, (std::vector<std::string>{"A.json", "b.cube", "d.3dl", "e.png"}));
    EXPECT_EQ(looks.reason, "");
    EXPECT_EQ(place_of(looks, folder.file("b.cube")), 1U);
    EXPECT_FALSE(place_of(looks, folder.file("c.txt")));
    EXPECT_FALSE(place_of(looks, "/elsewhere/b.cube"));
    EXPECT_NE(looks_in(folder.file("absent")).reason, "");
}

TEST(LookFolder, is_gone_through_around_its_ends) {
    EXPECT_EQ(place_beside(std::nullopt, 1, 3), 0U);
    EXPECT_EQ(place_beside(std::nullopt, -1, 3), 2U);
    EXPECT_EQ(place_beside(1, 1, 3), 2U);
    EXPECT_EQ(place_beside(2, 1, 3), 0U);
    EXPECT_EQ(place_beside(0, -1, 3), 2U);
}

TEST(LookFolder, knows_the_file_of_the_look_that_is_edited) {
    const ScratchFolder folder;
    overwrite(folder.file("a.cube"), cube_of(1));
    overwrite(folder.file("b.json"), recipe_of(1, "a.cube"));
    State state = initial_state();
    EXPECT_EQ(file_of_look(state), "");
    open_look(state, lutlib::io::Look::open(folder.file("a.cube")));
    EXPECT_EQ(file_of_look(state), path_of(folder) + "/a.cube");
    open_look(state,
              lutlib::io::Look::open(path_of(folder) + "/../" +
                                     fs::path(path_of(folder)).filename().string() + "/b.json"));
    EXPECT_EQ(file_of_look(state), path_of(folder) + "/b.json") << "its base is not it";
    fs::remove(folder.file("b.json"));
    EXPECT_EQ(file_of_look(state), path_of(folder) + "/b.json") << "what is gone had its folder";
    state.recipe_path = "-";
    EXPECT_EQ(file_of_look(state), "") << "standard input has no folder";
}

} // namespace
} // namespace preview::editor
