// What a command line may not ask for: exit code 3, before anything is read or written, in words
// that name the option and what it takes.
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace converter_test {
namespace {

struct Row {
    std::vector<std::string> arguments; ///< LOOK and OUT stand for paths
    std::string said;
};

const std::vector<Row>& rows() {
    static const std::vector<Row> table{
        {{"bake", "LOOK", "-o", "OUT.png", "--size", "257"}, "--size: Value 257 not in range 2 to"},
        {{"bake", "LOOK", "-o", "OUT.png", "--size", "-3"}, "--size: Value -3 not in range 2 to"},
        {{"bake", "LOOK", "-o", "OUT.png", "--size", "0"}, "--size: Value 0 not in range 2 to 256"},
        {{"bake", "LOOK", "-o", "OUT.png", "--bits", "0"}, "--bits: 0 not in {8,16}"},
        {{"bake", "LOOK", "-o", "OUT.png", "--bits", "9"}, "--bits: 9 not in {8,16}"},
        {{"bake", "LOOK", "-o", "OUT.png", "--max-delta-e", "0"},
         "--max-delta-e: '0' is not a number above 0"},
        {{"bake", "LOOK", "-o", "OUT.png", "--max-delta-e", "nan"},
         "--max-delta-e: 'nan' is not a number above 0"},
        {{"bake", "LOOK", "-o", "OUT.cube"}, "bake writes PNG, but -o names "},
        {{"bake", "LOOK", "-o", "OUT.jpg"}, "bake writes PNG, but -o names "},
        {{"check", "LOOK", "--explain", "--tolerance", "nan"},
         "--tolerance: 'nan' is not a number of 0 or more"},
        {{"compare", "LOOK", "LOOK", "--samples", "0"}, "--samples must be a number from 1"},
        {{"compare", "LOOK", "LOOK", "--domain", "1", "0"},
         "--domain takes a minimum and a maximum above it, not 1 and 0"},
        {{"invert", "LOOK", "-o", "OUT.cube", "--domain", "0", "inf"}, "--domain takes a minimum"},
        {{"invert", "LOOK", "-o", "OUT.cube", "--size", "0"}, "--size: Value 0 not in range"},
        {{"convert", "LOOK", "-o", "OUT.cube", "--size", "0"}, "--size: Value 0 not in range"},
        {{"resample", "LOOK", "-o", "OUT.cube", "--domain", "1", "0"}, "--domain takes a minimum"},
        {{"resample", "LOOK", "-o", "OUT.cube", "--size", "0"}, "--size: Value 0 not in range"},
        {{"resample", "LOOK", "-o", "OUT.cube", "--shaper", "srgb", "--shaper-size", "1"},
         "--shaper-size: Value 1 not in range 2 to 65536"},
        {{"resample", "LOOK", "-o", "OUT.cube", "--shaper-size", "9"},
         "--shaper-size needs a --shaper"},
        {{"edit", "LOOK", "-o", "OUT.cube", "--shaper-size", "9"},
         "--shaper-size needs a --shaper"},
        {{"edit", "LOOK", "-o", "OUT.cube", "--shaper", "none", "--shaper-size", "9"},
         "--shaper-size needs a --shaper"},
        {{"report", "LOOK", "-o", "OUT.html", "--sizes", "8", "1"},
         "--sizes: Value 1 not in range"},
        {{"report", "LOOK", "-o", "OUT.html", "--max-delta-e", "nan"}, "--max-delta-e: 'nan'"},
        {{"identity", "-o", "OUT.cube", "--bits", "9"}, "--bits: 9 not in {8,16}"},
        {{"identity", "-o", "OUT.cube", "--bits", "8"}, "--bits is for pictures"},
        {{"identity", "-o", "OUT.cube", "--size", "0"}, "--size: Value 0 not in range"},
        {{"identity", "-o", "OUT.cube", "--engine", "unity"}, "--engine writes PNG, but -o names "},
        {{"compose", "-", "LOOK", "-", "-o", "OUT.cube"},
         "only one input can come from standard input"},
        {{"blend", "-", "-", "-o", "OUT.cube"}, "only one input can come from standard input"},
        {{"compare", "-", "-"}, "only one input can come from standard input"},
        {{"foo"}, "there is no verb 'foo'; there are bake, verify, "},
        {{"foo", "--help"}, "there is no verb 'foo'; there are bake, verify, "},
        {{"eval", "LOOK", "--nope", "1", "2", "3"}, "there is no flag '--nope'"},
        {{"eval", "LOOK", "1", "2", "3", "-x"}, "there is no flag '-x'"},
        {{"info", "LOOK", "--", "1"}, "not expected: 1"},
    };
    return table;
}

TEST(Usage, that_is_bad_exits_with_3_and_names_the_option_and_what_it_takes) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(3));
    for (const Row& row : rows()) {
        std::vector<std::string> words = row.arguments;
        std::string line;
        for (std::string& word : words) {
            line.append(word).append(" ");
            if (word == "LOOK") {
                word = look;
            } else if (word.starts_with("OUT")) {
                word = folder.path(word);
            }
        }
        const Result result = lutconv(words);
        EXPECT_EQ(result.exit_code, 3) << line;
        EXPECT_NE(result.err.find(row.said), std::string::npos) << line << '\n' << result.err;
        EXPECT_EQ(result.out, "") << line;
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"look.cube"});
}

TEST(Usage, that_is_good_stays_so) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(3));
    const std::string wide = folder.write(
        "wide.cube", "LUT_1D_SIZE 2\nDOMAIN_MIN -3 -3 -3\nDOMAIN_MAX 2 2 2\n-3 -3 -3\n2 2 2\n");
    EXPECT_EQ(lutconv({"eval", wide, "--", "-1", "-2", "-3"}).out, "-1 -2 -3\n");
    EXPECT_EQ(lutconv({"eval", wide, "-1", "-2", "--", "-3"}).out, "-1 -2 -3\n");
    EXPECT_EQ(
        lutconv({"eval", wide, "--interpolation", "nearest", "--json", "--", "-1", "-2", "-3"})
            .exit_code,
        0);
    EXPECT_EQ(lutconv({"bake", look, "-o", folder.path("strip")}).exit_code, 0);
    EXPECT_EQ(lutconv({"bake", look, "-o", folder.path("x.PNG")}).exit_code, 0);
    EXPECT_EQ(lutconv({"bake", look, "-o", "/dev/null"}).exit_code, 0);
    EXPECT_EQ(lutconv({"resample", look, "-o", folder.path("x.cube"), "--domain", "-1", "2",
                       "--shaper", "srgb", "--shaper-size", "9"})
                  .exit_code,
              0);
    const std::string recipe =
        folder.write("r.json", R"({"schema_version": 1, "bake": {"shaper": "tone", "size": 4}})");
    EXPECT_EQ(
        lutconv({"edit", recipe, "-o", folder.path("x.cube"), "--shaper-size", "9"}).exit_code, 0);
    EXPECT_NE(contents(folder.path("x.cube")).find("LUT_1D_SIZE 9"), std::string::npos);
}

// An option that can change nothing in a run is said once, and the run goes on.
TEST(UnusedOptions, are_said_on_standard_error) {
    const Folder folder;
    const std::string cube = folder.write("a.cube", saturated_cube(3)),
                      curve = folder.write("c.cube", "LUT_1D_SIZE 2\n0 0 0\n.5 .5 .5\n"),
                      out = folder.path("o.cube"), picture = folder.path("o.png"),
                      stripped = folder.path("t.png");
    ASSERT_EQ(lutconv({"bake", cube, "-o", picture}).exit_code, 0);
    const std::vector<Row> lines{
        {{"convert", cube, "-o", out, "--bits", "8"}, "--bits"},
        {{"convert", curve, "-o", out, "--size", "5"}, "--size"},
        {{"convert", cube, "-o", out, "--row", "0"}, "--row"},
        {{"convert", cube, "-o", folder.path("o.spi3d"), "--title", "x"}, "--title"},
        {{"convert", cube, "-o", out, "--layout", "strip"}, "--layout"},
        {{"resample", curve, "-o", out, "--interpolation", "tricubic"}, "--interpolation"},
        {{"invert", curve, "-o", out, "--outside", "nearest"}, "--outside"},
        {{"invert", cube, "-o", out, "--encoding", "logc3"}, "--encoding"},
        {{"edit", cube, "-o", out, "--adaptation", "cat02"}, "--adaptation"},
        {{"bake", cube, "-o", picture, "--reference-white", "100"}, "--reference-white"},
        {{"eval", curve, "--interpolation", "nearest", "0", "0", "0"}, "--interpolation"},
        {{"apply", cube, picture, "-o", folder.path("a.png"), "--alpha", "straight"}, "--alpha"},
        {{"check", cube, "--tolerance", "1"}, "--tolerance"},
        {{"convert", picture, "-o", stripped, "--strip-tags", "--bits", "8"}, "--bits"},
        {{"convert", picture, "-o", stripped, "--strip-tags", "--look-input", "pq"},
         "--look-input"},
        {{"convert", picture, "-o", stripped, "--strip-tags", "--look-output", "pq"},
         "--look-output"},
        {{"convert", picture, "-o", stripped, "--strip-tags", "--adaptation", "cat02"},
         "--adaptation"},
        {{"convert", picture, "-o", stripped, "--strip-tags", "--no-convert"}, "--no-convert"},
        {{"convert", picture, "-o", stripped, "--strip-tags", "--strict"}, "--strict"},
        {{"convert", cube, "-o", out, "--no-convert"}, "--no-convert"},
        {{"bake", cube, "-o", picture, "--no-convert"}, "--no-convert"},
        {{"verify", picture, "--against", cube, "--no-convert"}, "--no-convert"},
        {{"apply", cube, picture, "-o", folder.path("b.png"), "--no-convert"}, "--no-convert"},
        {{"edit", cube, "-o", out, "--highlights-bleach", "0.9"}, "operator highlights"},
        {{"edit", cube, "-o", out, "--contrast-pivot", "0.7"}, "operator contrast"},
        {{"edit", cube, "-o", out, "--split-shadow-hue", "200"}, "operator split-toning"},
        {{"edit", cube, "-o", out, "--range-centre", "90"}, "operator hue-range"},
        {{"edit", cube, "-o", out, "--gamut-threshold", "0.5"}, "operator gamut-compression"},
        {{"identity", "-o", out, "--place", "right"}, "--place"},
        {{"edit", cube, "--exposure", "1", "--save-recipe", folder.path("r.json"), "--json"},
         "--json"},
        {{"edit", "identity", "--cdl-offset", "0", "--cdl-clamp", "on", "--save-cdl",
          folder.path("o.ccc"), "--size", "9"},
         "--size"},
        {{"sheet", picture, cube, "-o", folder.path("s.png"), "--no-convert"}, "--no-convert"},
    };
    for (const Row& line : lines) {
        const Result result = lutconv_in_process(line.arguments);
        EXPECT_EQ(result.exit_code, 0) << line.said << result.err;
        EXPECT_EQ(result.err.find("lutconv: " + line.said + " changes nothing here: "), 0U)
            << line.said << ": " << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    }
    EXPECT_EQ(
        lutconv_in_process({"convert", picture, "-o", out, "--layout", "strip", "--row", "0"}).err,
        "");
}

} // namespace
} // namespace converter_test
