// lutconv edit: ASC CDL files into a look, and out of it.
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace converter_test {
namespace {

using nlohmann::json;

TEST(EditCdl, takes_corrections_of_cdl_files_and_writes_them) {
    const Folder folder;
    const std::string shots = folder.path("shots.ccc"), recipe = folder.path("x.json");
    const auto saved = [&](const std::string& id, const char* slope) {
        return lutconv({"edit", "identity", "--cdl-slope", slope, "--cdl-offset", "-0.1,0,0",
                        "--exposure", "1", "--save-cdl", shots, "--save-cdl-id", id});
    };
    const Result first = saved("sh010", "1.25,1,1");
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_NE(first.err.find("shots.ccc: lost: the look's other operators are left out: 1"),
              std::string::npos)
        << first.err;
    EXPECT_NE(first.err.find("differ by at most: 0.15"), std::string::npos) << first.err;
    EXPECT_EQ(saved("sh020", "0.5").exit_code, 0);
    EXPECT_EQ(saved("sh010", "1.5,1,1").exit_code, 0) << "in place of the first";
    const Result read = lutconv({"edit", "identity", "-o", folder.path("x.cube"), "--exposure",
                                 "0.5", "--cdl-file", shots, "--cdl-id", "sh020", "--cdl-clamp",
                                 "on", "--cdl-slope", "2", "--save-recipe", recipe});
    EXPECT_EQ(read.exit_code, 0) << read.err;
    const json operators = json::parse(contents(recipe))["operators"];
    ASSERT_EQ(operators.size(), 3U);
    EXPECT_EQ(operators[1]["slope"], json({.5, .5, .5}));
    EXPECT_EQ(operators[1]["offset"], json({-.1, 0, 0}));
    EXPECT_EQ(operators[1]["clamp"], true);
    EXPECT_EQ(operators[2], json({{"op", "cdl"}, {"slope", {2, 2, 2}}}));
    // The first, which is said.
    const Result unnamed =
        lutconv({"edit", "identity", "-o", folder.path("y.cube"), "--cdl-file", shots, "--json"});
    ASSERT_EQ(unnamed.exit_code, 0) << unnamed.err;
    EXPECT_EQ(json::parse(unnamed.out)["cdl"]["read"][0]["figure"], 2);
    EXPECT_NEAR(std::stod(lutconv({"eval", folder.path("y.cube"), "0.5", "0.5", "0.5"}).out), 0.65,
                1e-6);
    const std::string other = folder.write(
        "wild.cc", "<ColorCorrection><SOPNode><Power>0 1 1</Power></SOPNode></ColorCorrection>");
    EXPECT_NE(lutconv({"edit", "identity", "-o", folder.path("z.cube"), "--cdl-file", other})
                  .err.find("power of red is 0"),
              std::string::npos);
}

TEST(EditCdl, refuses_cdl_options_that_make_no_sense) {
    const Folder folder;
    const std::string out = folder.path("x.cube"), none = folder.write("a.cc", "<cube/>");
    const std::string two =
        folder.write("b.ccc", "<ColorCorrectionCollection><ColorCorrection id=\"a\"/>"
                              "</ColorCorrectionCollection>");
    EXPECT_EQ(lutconv({"edit", "identity", "-o", out, "--cdl-id", "a"}).exit_code, 3);
    EXPECT_EQ(
        lutconv({"edit", "identity", "-o", out, "--cdl-file", two, "--cdl-id", "b"}).exit_code, 3);
    EXPECT_EQ(lutconv({"edit", "identity", "-o", out, "--cdl-file", none}).exit_code, 2);
    EXPECT_EQ(lutconv({"edit", "identity", "--save-cdl", folder.path("y.cc")}).exit_code, 3)
        << "there is no CDL";
    EXPECT_EQ(lutconv({"edit", "identity", "--cdl-slope", "2", "--save-cdl", out}).exit_code, 3)
        << "no format";
    EXPECT_EQ(lutconv({"edit", "identity", "-o", out, "--save-cdl-id", "a"}).exit_code, 3);
    const Result foreign = lutconv({"edit", "identity", "--cdl-slope", "2", "--save-cdl", two});
    EXPECT_EQ(foreign.exit_code, 2) << "lutconv did not make it";
    EXPECT_EQ(lutconv({"edit", "identity", "--cdl-slope", "2", "--save-cdl", two, "--save-cdl-id",
                       "b", "--force"})
                  .exit_code,
              0);
    EXPECT_EQ(contents(two).find("<ColorCorrectionCollection><ColorCorrection id=\"a\"/>"), 0U);
    EXPECT_NE(contents(two).find("id=\"b\""), std::string::npos);
}

} // namespace
} // namespace converter_test
