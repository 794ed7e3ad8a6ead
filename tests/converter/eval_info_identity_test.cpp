#include "lutlib/engine/engine.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace converter_test {
namespace {

using nlohmann::json;

TEST(Eval, prints_nine_significant_digits_and_takes_negative_numbers) {
    const Folder folder;
    const std::string look = folder.write(
        "wide.cube", "LUT_1D_SIZE 2\nDOMAIN_MIN -1 -1 -1\nDOMAIN_MAX 2 2 2\n-1 -1 -1\n2 2 2\n");
    const Result result = lutconv({"eval", look, "-0.5", "0.25", "1.5", "nan", "-inf", "inf"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "-0.5 0.25 1.5\n-1 -1 2\n");
    EXPECT_EQ(lutconv({"eval", look, "0.1", "0.2"}).exit_code, 3);
    EXPECT_EQ(lutconv({"eval", look, "0.1", "0.2", "--bogus"}).exit_code, 3);
}

TEST(Eval, reads_lines_from_standard_input) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(9));
    const Result lines = lutconv({"eval", look}, "0 0 0\r\n\n1 1 1\n0.3 0.6 0.9");
    EXPECT_EQ(lines.exit_code, 0) << lines.err;
    const Result words = lutconv({"eval", look, "0", "0", "0", "1", "1", "1", "0.3", "0.6", "0.9"});
    EXPECT_EQ(lines.out, words.out);
    const Result bad = lutconv({"eval", look}, "0 0 0\n1 x 1\n");
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_NE(bad.err.find("standard input:2"), std::string::npos) << bad.err;
}

TEST(Eval, interpolates_as_asked) {
    const Folder folder;
    const std::string look = folder.write(
        "a.cube", "LUT_3D_SIZE 2\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n0 0 1\n0 0 0\n0 0 0\n1 1 1\n");
    const auto at_middle = [&](const char* how) {
        return lutconv({"eval", look, "0.5", "0.5", "0.5", "--interpolation", how}).out;
    };
    EXPECT_EQ(at_middle("nearest"), "1 1 1\n");
    EXPECT_EQ(at_middle("trilinear"), "0.25 0.25 0.25\n");
    EXPECT_EQ(at_middle("tetrahedral"), "0.5 0.5 0.5\n");
}

TEST(Info, says_what_is_in_a_resolve_file) {
    const Folder folder;
    const std::string look = folder.write(
        "r.cube", "# by hand\nTITLE \"Both\"\nLUT_1D_SIZE 2\nLUT_1D_INPUT_RANGE 0 4\n"
                  "LUT_3D_SIZE 2\n0 0 0\n1 1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 "
                  "1\n0 1 1\n1 1 2\n");
    const json info = json::parse(lutconv({"info", look, "--json"}).out);
    EXPECT_EQ(info["title"], "Both");
    EXPECT_EQ(info["shaper"]["domain_max"][0], 4);
    EXPECT_EQ(info["cube"]["size"], 2);
    EXPECT_EQ(info["cube"]["values_outside_0_1"], 1);
    EXPECT_EQ(info["comments"][0], "by hand");
    const std::string text = lutconv({"info", look}).out;
    EXPECT_NE(text.find("input 0..4"), std::string::npos) << text;
}

TEST(Identity, changes_nothing_as_cube_and_as_picture) {
    const Folder folder;
    for (const std::string name : {"i.cube", "i.png"}) {
        const std::string path = folder.path(name);
        ASSERT_EQ(lutconv({"identity", "-o", path, "--size", "16"}).exit_code, 0);
        const json info = json::parse(lutconv({"info", path, "--json"}).out);
        EXPECT_EQ(info["cube"]["size"], 16);
        // 16 nodes are whole 8-bit codes; what is left is float rounding.
        EXPECT_LT(info["distance_from_identity"]["max"].get<double>(), 1e-7);
    }
}

TEST(Info, says_what_a_picture_is_and_which_engines_take_it) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(9));
    const std::string picture = folder.path("strip.png");
    ASSERT_EQ(lutconv({"bake", look, "-o", picture, "--engine", "unreal"}).exit_code, 0);
    const std::string text = lutconv({"info", picture}).out;
    EXPECT_NE(text.find("layout: strip, 16 nodes per axis"), std::string::npos) << text;
    EXPECT_NE(text.find("take it as it is: piccolo, unreal"), std::string::npos) << text;
    const auto facts = nlohmann::json::parse(lutconv({"info", picture, "--json"}).out);
    EXPECT_EQ(facts["picture"]["layout"], "strip");
    EXPECT_EQ(facts["picture"]["bits"], 8);
    EXPECT_EQ(facts["picture"]["engine_in_text"], "unreal");
    EXPECT_TRUE(facts["picture"]["engines"]["piccolo"].empty());
    EXPECT_FALSE(facts["picture"]["engines"].contains("unity"));
    EXPECT_FALSE(nlohmann::json::parse(lutconv({"info", look, "--json"}).out).contains("picture"));
}

TEST(Layout, is_taken_by_verbs_that_read_pictures_whose_content_does_not_tell) {
    const Folder folder;
    const std::string look = folder.write(
        "grey.cube",
        "LUT_3D_SIZE 2\n0 0 0\n.2 .2 .2\n.7 .7 .7\n.9 .9 .9\n.1 .1 .1\n.3 .3 .3\n.8 .8 "
        ".8\n1 1 1\n");
    const std::string picture = folder.path("strip.png");
    ASSERT_EQ(
        lutconv({"convert", look, "-o", picture, "--format", "strip-up", "--size", "16"}).exit_code,
        0);
    const Result refused = lutconv({"eval", picture, "0", "1", "0"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find("--layout"), std::string::npos) << refused.err;
    const Result read = lutconv({"eval", picture, "0", "1", "0", "--layout", "strip-up"});
    EXPECT_EQ(read.exit_code, 0) << read.err;
    EXPECT_NEAR(std::stod(read.out), 0.7, 1e-4);
    EXPECT_EQ(lutconv({"eval", picture, "0", "1", "0", "--layout", "stripe"}).exit_code, 3);
}

TEST(Engines, lists_every_row_in_text_and_json) {
    const auto rows = nlohmann::json::parse(lutconv({"engines", "--json"}).out);
    const std::string text = lutconv({"engines"}).out;
    ASSERT_EQ(rows.size(), lutlib::engines().size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i]["name"], lutlib::engines()[i].name);
        EXPECT_NE(text.find(lutlib::engines()[i].label), std::string::npos);
    }
}

} // namespace
} // namespace converter_test
