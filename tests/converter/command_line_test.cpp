#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace converter_test {
namespace {

TEST(CommandLine, lists_its_verbs_and_each_has_help_and_refuses_nonsense) {
    const std::vector<std::string> all = verbs();
    ASSERT_GE(all.size(), 5U);
    for (const std::string& verb : all) {
        const Result help = lutconv({verb, "--help"});
        EXPECT_EQ(help.exit_code, 0) << verb;
        EXPECT_NE(help.out.find("Usage:"), std::string::npos) << verb;
        EXPECT_EQ(lutconv({verb, "--no-such-flag"}).exit_code, 3) << verb;
        const bool only_lists =
            verb == "engines" || verb == "encodings" || verb == "operators" || verb == "formats";
        EXPECT_EQ(lutconv({verb}).exit_code, only_lists ? 0 : 3) << verb;
    }
}

TEST(CommandLine, exits_with_3_on_bad_usage) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(3));
    EXPECT_EQ(lutconv({}).exit_code, 3);
    EXPECT_EQ(lutconv({"nonsense"}).exit_code, 3);
    const auto bake = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"bake", look, "-o", folder.path("x.png")});
        return lutconv(more);
    };
    EXPECT_EQ(bake({"--engine", "quake"}).exit_code, 3);
    EXPECT_EQ(bake({"--engine", "unreal", "--size", "32"}).exit_code, 3);
    EXPECT_EQ(bake({"--bits", "10"}).exit_code, 3);
    EXPECT_EQ(bake({"--size", "x"}).exit_code, 3);
    EXPECT_EQ(bake({"--interpolation", "psychic"}).exit_code, 3);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.cube"});
}

TEST(CommandLine, exits_with_2_and_one_line_for_every_bad_file) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(TESTS_BAD)) {
        if (entry.path().extension() != ".cube") {
            continue;
        }
        ++files;
        const Folder folder;
        const std::string out = folder.write("out.png", "old");
        const Result result = lutconv({"bake", entry.path().string(), "-o", out, "--force"});
        EXPECT_EQ(result.exit_code, 2) << entry.path();
        EXPECT_NE(result.err.find(entry.path().filename().string()), std::string::npos);
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        EXPECT_EQ(contents(out), "old");
    }
    EXPECT_GT(files, 20U);
}

TEST(CommandLine, exits_with_2_for_a_directory_a_missing_file_and_an_unwritable_target) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(3));
    EXPECT_EQ(lutconv({"info", folder.path("")}).exit_code, 2);
    EXPECT_EQ(lutconv({"info", folder.path("none.cube")}).exit_code, 2);
    EXPECT_EQ(lutconv({"bake", look, "-o", folder.path("none/x.png")}).exit_code, 2);
    EXPECT_EQ(lutconv({"bake", look, "-o", folder.path("")}).exit_code, 2);
}

} // namespace
} // namespace converter_test
