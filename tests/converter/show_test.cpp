// lutconv show: figures of one look or two.
#include "converter/panels/panel.h"
#include "lutlib/io/image.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>
#include <set>

namespace converter_test {
namespace {

using nlohmann::json;
namespace io = lutlib::io;

const std::regex no_number("[^a-z](nan|inf)[^a-z]");
const std::string named_curve = "# Input encoding: srgb\n# Output encoding: srgb\n"
                                "LUT_1D_SIZE 2\n0 0 0.1\n0.8 0.9 1\n";

TEST(Show, draws_all_panels_as_a_picture_a_drawing_and_a_page) {
    const Folder folder;
    const std::string look = folder.write("dim.cube", named_curve);
    const std::string png = folder.path("dim.png");
    const Result picture = lutconv_in_process({"show", look, "-o", png, "--size", "640"});
    ASSERT_EQ(picture.exit_code, 0) << picture.err;
    EXPECT_EQ(picture.err, "");
    const io::FloatImage image = io::read_image(png);
    EXPECT_EQ(image.width, 640);
    EXPECT_GT(image.height, 640);
    std::set<std::array<float, 3>> colors;
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        colors.insert({image.rgba[4 * i], image.rgba[4 * i + 1], image.rgba[4 * i + 2]});
    }
    EXPECT_GT(colors.size(), 500U);

    const std::string svg = folder.path("dim.svg"), html = folder.path("dim.html");
    ASSERT_EQ(lutconv_in_process({"show", look, "-o", svg}).exit_code, 0);
    ASSERT_EQ(lutconv_in_process({"show", look, "-o", html}).exit_code, 0);
    EXPECT_TRUE(contents(svg).starts_with("<svg xmlns="));
    EXPECT_NE(contents(svg).find("width=\"1920\""), std::string::npos);
    const std::string page = contents(html);
    for (const converter::Panel* panel : converter::panels()) {
        EXPECT_NE(picture.out.find(panel->name), std::string::npos) << picture.out;
        EXPECT_NE(page.find("<h2>" + std::string(panel->label).substr(0, 10)), std::string::npos)
            << panel->label;
    }
    for (const std::string& text : {contents(svg), page}) {
        for (const char* words : {"neutral axis", "Slope", "Hue against luminance", "saturation",
                                  "Gamut hull in CIE 1976 u'v'", "Oklab", "dim"}) {
            EXPECT_NE(text.find(words), std::string::npos) << words;
        }
        EXPECT_FALSE(std::regex_search(text, no_number));
    }
    // Self-contained.
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_EQ(page.find("src="), std::string::npos);
    EXPECT_EQ(page.find("<table"), std::string::npos);
}

TEST(Show, says_the_numbers_behind_the_panels) {
    const Folder folder;
    const std::string look = folder.write("dim.cube", named_curve);
    const Result result =
        lutconv_in_process({"show", look, "--json", "--panels", "slopes,curves,slopes"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json all = json::parse(result.out);
    ASSERT_EQ(all["panels"].size(), 2U);
    EXPECT_EQ(all["panels"][0]["name"], "slopes"); // as they were asked for
    const json& lines = all["panels"][1]["figures"][0]["lines"];
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[3]["name"], "blue");
    for (const json& point : lines[3]["points"]) {
        EXPECT_NEAR(point[1].get<double>(), 0.1 + 0.9 * point[0].get<double>(), 1e-6);
    }
    EXPECT_EQ(all["looks"][0]["input"], "srgb");
    EXPECT_EQ(all["looks"][0]["input_is_guessed"], false);
}

TEST(Show, two_looks_share_axes_and_are_told_apart_by_name_colour_and_dash) {
    const Folder folder;
    const std::string a = folder.write("day.cube", named_curve),
                      b = folder.write("night.cube", saturated_cube(5));
    const std::string svg = folder.path("both.svg");
    const Result result =
        lutconv_in_process({"show", a, b, "-o", svg, "--panels", "hull-uv,curves"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string text = contents(svg);
    for (const char* words : {"day, red", "night, red", "stroke-dasharray", "day and night"}) {
        EXPECT_NE(text.find(words), std::string::npos) << words;
    }
    // The guess is said, and of whom.
    EXPECT_NE(result.out.find("is taken for srgb"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("--look-output): night"), std::string::npos) << result.out;
    EXPECT_EQ(lutconv_in_process({"show", a, a, "-o", svg}).exit_code, 0);
    EXPECT_NE(contents(svg).find("(2)"), std::string::npos);
}

TEST(Show, takes_the_encodings_that_are_named) {
    const Folder folder;
    const std::string look = folder.write("x.cube", saturated_cube(5));
    const Result result = lutconv_in_process({"show", look, "--json", "--panels", "hue",
                                              "--look-input", "logc3", "--look-output", "rec709"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json all = json::parse(result.out);
    EXPECT_EQ(all["looks"][0]["input"], "logc3");
    EXPECT_EQ(all["looks"][0]["output"], "rec709");
    // LogC3 holds some stops of light more than a display's codes.
    const json& points = all["panels"][0]["figures"][0]["lines"][0]["points"];
    EXPECT_GT(points.back()[0].get<double>(), 5);
}

TEST(Show, draws_looks_of_every_sample) {
    const Folder folder;
    for (const std::string& name : names_in(SAMPLE_LOOKS)) {
        if (name.ends_with(".json")) {
            const Result result = lutconv_in_process(
                {"show", std::string(SAMPLE_LOOKS) + "/" + name, "-o", folder.path(name + ".svg")});
            EXPECT_EQ(result.exit_code, 0) << name << result.err;
            EXPECT_FALSE(std::regex_search(contents(folder.path(name + ".svg")), no_number))
                << name;
        }
    }
}

TEST(Show, refuses_what_it_cannot_draw_before_anything_is_written) {
    const Folder folder;
    const std::string look = folder.write("x.cube", saturated_cube(3));
    const std::string png = folder.path("x.png");
    const auto refused = [&](std::vector<std::string> words, const std::string& said) {
        words.insert(words.begin(), "show");
        const Result result = lutconv_in_process(words);
        EXPECT_EQ(result.exit_code, 3) << said;
        EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
    };
    refused({look}, "show needs -o FILE");
    refused({look, "-o", png, "--size", "1"}, "--size must be 320 to 8192");
    refused({look, "-o", png, "--panels", "slice"}, "did you mean slices?");
    refused({look, "-o", folder.path("x.exr")}, "picture of 8 bits");
    refused({look, look, look, "-o", png}, "");
    refused({"-", "-", "-o", png}, "only one input can come from standard input");
    EXPECT_EQ(lutconv_in_process({"show", folder.path("gone.cube"), "-o", png}).exit_code, 2);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"x.cube"});
    const Result unused =
        lutconv_in_process({"show", look, "-o", folder.path("x.html"), "--size", "640"});
    EXPECT_EQ(unused.exit_code, 0);
    EXPECT_NE(unused.err.find("--size changes nothing here"), std::string::npos) << unused.err;
}

} // namespace
} // namespace converter_test
