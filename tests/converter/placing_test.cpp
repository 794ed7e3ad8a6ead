// Looks that are made for other code values than an engine or a picture gives.
#include "lutlib/engine/engine.h"
#include "lutlib/io/image.h"
#include "lutlib/io/look.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/png.h"
#include "tests/converter/run_program.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace converter_test {
namespace {

using nlohmann::json;

const std::string log_recipe = SAMPLE_LOOKS "/log_to_display.json";

json run(std::vector<std::string> words, int exit_code = 0) {
    words.emplace_back("--json");
    const Result result = lutconv_in_process(words);
    EXPECT_EQ(result.exit_code, exit_code) << words[0] << ": " << result.out << result.err;
    return json::parse(result.out, nullptr, false);
}

class LogLook : public testing::TestWithParam<lutlib::Engine> {};
INSTANTIATE_TEST_SUITE_P(Engines, LogLook,
                         testing::ValuesIn(support::rows_to_try(lutlib::engines())),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(LogLook, is_converted_to_the_codes_of_the_engine_and_left_as_it_is_passes_only_as_that) {
    const Folder folder;
    const std::string engine(GetParam().name), strip = folder.path("strip.png");
    const bool converts = !GetParam().encoding.empty();
    const json baked = run({"bake", log_recipe, "-o", strip, "--engine", engine});
    EXPECT_EQ(baked["encodings"]["look"]["input"], "logc3");
    EXPECT_EQ(baked["encodings"]["before"].is_null(), !converts);
    EXPECT_TRUE(run({"verify", strip, "--against", log_recipe, "--samples", "50"})["passed"]);

    const std::string left = folder.path("left.png");
    run({"bake", log_recipe, "-o", left, "--engine", engine, "--no-convert"});
    const std::vector<std::string> verify{"verify",   left,        "--against",
                                          log_recipe, "--samples", "50"};
    const json verdict = run(verify, converts ? 1 : 0);
    std::vector<std::string> without = verify;
    without.emplace_back("--no-convert");
    const json meant = run(without);
    EXPECT_TRUE(meant["passed"]);
    EXPECT_EQ(meant["encodings"]["mismatched"], converts);
    EXPECT_FALSE(meant.contains("diagnosis"));
    if (converts) {
        EXPECT_NE(verdict["diagnosis"]["words"].get<std::string>().find("logc3"), std::string::npos)
            << verdict;
        EXPECT_GT(verdict["diagnosis"]["explained"], 0.99);
    }
}

// sRGB and LogC3 by their published formulas.
TEST(BakeOfALogLook, holds_the_look_at_the_log_codes_of_each_node) {
    const Folder folder;
    const std::string strip = folder.path("strip.png");
    // Nothing but the encodings: green of LogC3's code, as the engine's sRGB code gives it.
    const std::string look = folder.write("look.cube", "# Input encoding: logc3/rec709\n"
                                                       "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    run({"bake", look, "-o", strip, "--engine", "unreal", "--look-output", "srgb"});
    const lutlib::io::PngImage image = lutlib::io::read_png(contents(strip), "strip.png");
    for (std::size_t i = 0; i < 16; ++i) {
        const double v = static_cast<double>(i) / 15;
        const double light = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        const double log = light > 0.010591
                               ? 0.247190 * std::log10(5.555556 * light + 0.052272) + 0.385537
                               : 5.367655 * light + 0.092809;
        // Node (0, i, 0) lies at x = 0, y = i of the strip.
        EXPECT_NEAR(image.samples[i * 256 * 3 + 1], std::round(255 * log), 0.51) << i;
    }
}

TEST(BakeOfALook, whose_encodings_nobody_knows_says_so_once_and_takes_them_for_the_engines) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(5));
    const Result baked = lutconv_in_process({"bake", look, "-o", folder.path("s.png")});
    const std::string words = "not known and taken for srgb";
    const std::size_t at = baked.out.find(words);
    EXPECT_NE(at, std::string::npos) << baked.out;
    EXPECT_EQ(baked.out.find(words, at + 1), std::string::npos);
    EXPECT_TRUE(baked.err.empty()) << baked.err;
    const Result verified = lutconv_in_process({"verify", folder.path("s.png"), "--against", look});
    EXPECT_EQ(verified.exit_code, 0);
    EXPECT_NE(verified.out.find("; right if the look is made for srgb"), std::string::npos);
}

TEST(VerifyOfALogLook, knows_from_the_picture_what_bake_was_told) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(5)),
                      strip = folder.path("s.png");
    run({"bake", look, "-o", strip, "--look-input", "slog3", "--look-output", "rec709"});
    const json verdict = run({"verify", strip, "--against", look, "--samples", "50"});
    EXPECT_EQ(verdict["encodings"]["look"]["input"], "slog3");
    EXPECT_TRUE(verdict["passed"]);
}

TEST(ConvertOfALook, writes_its_encodings_and_reads_them_back) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(5)),
                      named = folder.path("named.cube");
    run({"convert", look, "-o", named, "--look-input", "slog3/sgamut3", "--look-output", "rec709"});
    EXPECT_NE(contents(named).find("# Input encoding: slog3/sgamut3\n"), std::string::npos);
    const json baked = run({"bake", named, "-o", folder.path("s.png")});
    EXPECT_EQ(baked["encodings"]["before"]["to"], "slog3/sgamut3");
    EXPECT_EQ(baked["encodings"]["after"]["from"], "rec709");
    const Result lost =
        lutconv_in_process({"convert", named, "-o", folder.path("l.spi3d"), "--strict"});
    EXPECT_EQ(lost.exit_code, 2);
    EXPECT_NE(lost.err.find("encodings not written"), std::string::npos) << lost.err;
}

TEST(ConvertOfALook, to_a_picture_that_engines_read_converts_as_bake_does) {
    const Folder folder;
    const std::string strip = folder.path("strip.png"), baked = folder.path("baked.png");
    run({"convert", log_recipe, "-o", strip, "--format", "strip", "--size", "16", "--bits", "8"});
    run({"bake", log_recipe, "-o", baked, "--engine", "unreal"});
    EXPECT_EQ(lutlib::io::read_png(contents(strip), "").samples,
              lutlib::io::read_png(contents(baked), "").samples);
}

TEST(ComposeOfLooks, keeps_the_outer_encodings_and_says_where_the_inner_ones_differ) {
    const Folder folder;
    const std::string head = "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n";
    const std::string first = folder.write("a.cube", "# Input encoding: logc3\n# Output encoding: "
                                                     "srgb\n" +
                                                         head);
    const std::string second = folder.write("b.cube", "# Input encoding: slog3\n# Output encoding: "
                                                      "rec709\n" +
                                                          head);
    const std::string out = folder.path("out.cube");
    const Result result = lutconv_in_process({"compose", first, second, "-o", out});
    EXPECT_NE(result.out.find("gives srgb and"), std::string::npos) << result.out;
    const json info = run({"info", out});
    EXPECT_EQ(info["encodings"]["input"], "logc3");
    EXPECT_EQ(info["encodings"]["output"], "rec709");
    run({"invert", first, "-o", out});
    EXPECT_EQ(run({"info", out})["encodings"]["input"], "srgb");
    run({"edit", second, "--exposure", "0.1", "-o", out});
    EXPECT_EQ(run({"info", out})["encodings"]["output"], "rec709");
}

class ApplyOfALook : public testing::Test {
  protected:
    const Folder folder;

    std::string grey_picture(float value) const {
        lutlib::io::FloatImage image;
        image.width = 2;
        image.height = 1;
        image.rgba = {value, value, value, 1, value, value, value, 1};
        lutlib::io::write_image(folder.path("in.exr"), image,
                                {lutlib::io::Depth::float32, false, {}});
        return folder.path("in.exr");
    }
    float applied(const std::vector<std::string>& more, const std::string& head) const {
        const std::string look =
            folder.write("look.cube", head + "LUT_1D_SIZE 2\n0 0 0\n0.5 0.5 0.5\n");
        std::vector<std::string> words{"apply", look, grey_picture(0.18F), "-o",
                                       folder.path("out.exr")};
        words.insert(words.end(), more.begin(), more.end());
        run(words);
        return lutlib::io::read_image(folder.path("out.exr")).rgba[0];
    }
};

TEST_F(ApplyOfALook, of_one_encoding_goes_from_the_pictures_to_it_and_back) {
    const std::string head = "# Input encoding: srgb\n# Output encoding: srgb\n";
    // Half the sRGB code of 0.18 is 0.2307, which is light of 0.0434.
    EXPECT_NEAR(applied({"--picture-encoding", "linear"}, head), 0.0434, 5e-4);
    // An EXR holds light, where nobody says otherwise.
    EXPECT_NEAR(applied({}, head), 0.0434, 5e-4);
    EXPECT_NEAR(applied({"--picture-encoding", "srgb"}, head), 0.09, 1e-6);
    EXPECT_NEAR(applied({"--picture-encoding", "linear", "--no-convert"}, head), 0.09, 1e-6);
}

TEST_F(ApplyOfALook, that_changes_the_encoding_gives_what_it_gives_unless_told_otherwise) {
    const std::string head = "# Input encoding: srgb\n# Output encoding: gamma24\n";
    EXPECT_NEAR(applied({"--picture-encoding", "linear/rec709"}, head), 0.2307, 5e-4);
    // 0.2307^2.4
    EXPECT_NEAR(
        applied({"--picture-encoding", "linear/rec709", "--output-encoding", "linear/rec709"},
                head),
        0.0296, 5e-4);
}

TEST_F(ApplyOfALook, says_what_the_picture_is_taken_for_and_what_the_result_holds) {
    const std::string look =
        folder.write("look.cube", "# Input encoding: logc3\n# Output encoding: srgb\n"
                                  "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    const std::string light = grey_picture(0.18F), png = folder.path("in.png");
    const Result exr = lutconv_in_process({"apply", look, light, "-o", folder.path("out.exr")});
    EXPECT_NE(exr.out.find("the picture holds linear by its file type"), std::string::npos)
        << exr.out;
    EXPECT_NE(exr.out.find("the result holds srgb, but readers expect linear light in .exr files"),
              std::string::npos)
        << exr.out;
    lutconv_in_process({"apply", look, light, "-o", png});
    const Result codes = lutconv_in_process({"apply", look, png, "-o", folder.path("out.png")});
    EXPECT_NE(codes.out.find("taken for the look's input, logc3"), std::string::npos) << codes.out;
    const Result said = lutconv_in_process(
        {"apply", look, png, "-o", folder.path("out.png"), "--output-encoding", "rec709"});
    EXPECT_NE(said.out.find("taken for the look's input, logc3"), std::string::npos) << said.out;
    EXPECT_NE(said.out.find("srgb is converted to rec709 after the look"), std::string::npos)
        << said.out;
}

TEST_F(ApplyOfALook, counts_pixels_that_hold_what_is_no_number) {
    const std::string look = folder.write("look.cube", "# Input encoding: srgb\n# Output encoding: "
                                                       "srgb\nLUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    const json report = run({"apply", look, grey_picture(std::numeric_limits<float>::quiet_NaN()),
                             "-o", folder.path("out.exr")});
    EXPECT_EQ(report["pixels_not_a_number"], 2);
}

TEST_F(ApplyOfALook, counts_it_also_where_nothing_is_converted) {
    const std::string look = folder.write("look.cube", "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    const std::string picture = grey_picture(std::numeric_limits<float>::quiet_NaN());
    for (const char* const strength : {"1", "0.5"}) { // as they are stored, and as floats
        const json report =
            run({"apply", look, picture, "-o", folder.path("out.exr"), "--strength", strength});
        EXPECT_EQ(report["pixels_not_a_number"], 2) << strength;
        EXPECT_EQ(report["pixels_outside_domain"], 0) << strength;
    }
}

TEST_F(ApplyOfALook, says_that_encodings_have_no_part_where_the_looks_are_unknown) {
    const std::string look = folder.write("look.cube", "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    const Result result =
        lutconv_in_process({"apply", look, grey_picture(0.5F), "-o", folder.path("out.exr"),
                            "--picture-encoding", "slog3", "--output-encoding", "linear"});
    for (const char* const option : {"--picture-encoding", "--output-encoding"}) {
        EXPECT_NE(result.err.find(option), std::string::npos) << result.err;
    }
}

TEST_F(ApplyOfALook, does_not_write_over_the_look) {
    const std::string strip = folder.path("strip.png");
    ASSERT_EQ(lutconv_in_process({"bake", folder.write("a.cube", saturated_cube(3)), "-o", strip,
                                  "--engine", "unity", "--size", "16", "--quiet"})
                  .exit_code,
              0);
    const std::string before = contents(strip);
    const Result result =
        lutconv_in_process({"apply", strip, grey_picture(0.5F), "-o", folder.path("./strip.png")});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_NE(result.err.find("names the look itself"), std::string::npos) << result.err;
    EXPECT_EQ(contents(strip), before);
}

TEST_F(ApplyOfALook, of_strength_0_leaves_what_is_not_finite_too) {
    const std::string look = folder.write("look.cube", "LUT_1D_SIZE 2\n1 1 1\n0 0 0\n");
    run({"apply", look, grey_picture(std::numeric_limits<float>::infinity()), "-o",
         folder.path("out.exr"), "--strength", "0"});
    EXPECT_EQ(lutlib::io::read_image(folder.path("out.exr")).rgba[0],
              std::numeric_limits<float>::infinity());
}

TEST(VerifyOfALogLook, says_which_encodings_are_the_pictures_word_alone) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(5)),
                      strip = folder.path("s.png");
    run({"bake", look, "-o", strip, "--look-input", "logc3", "--look-output", "srgb"});
    const Result passed = lutconv_in_process({"verify", strip, "--against", look});
    EXPECT_NE(passed.out.find("; right if the look is made for input logc3, output srgb"),
              std::string::npos)
        << passed.out;
    const Result wrong =
        lutconv_in_process({"verify", strip, "--against", look, "--look-input", "slog3"});
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_NE(wrong.out.find("baked as a look of other encodings"), std::string::npos) << wrong.out;
    const Result flag = lutconv_in_process({"verify", strip, "--against", look, "--no-convert"});
    EXPECT_NE(flag.out.find("verify it without --no-convert"), std::string::npos) << flag.out;
}

// Two spaces apart by a power of 2.
std::string config_text() {
    return "ocio_profile_version: 2\nroles: {default: light}\n"
           "displays:\n  Screen:\n    - !<View> {name: Film, colorspace: codes}\n"
           "colorspaces:\n  - !<ColorSpace> {name: light}\n"
           "  - !<ColorSpace>\n    name: codes\n    from_scene_reference: !<ExponentTransform> "
           "{value: 2, style: clamp, direction: inverse}\n";
}

TEST(OcioConfig, is_baked_before_a_look_or_alone_and_verified_so) {
    const Folder folder;
    const std::string config = folder.write("c.ocio", config_text()), strip = folder.path("s.png"),
                      look = folder.write("half.cube", "LUT_1D_SIZE 2\n0 0 0\n.5 .5 .5\n");
    for (const std::string& base : {std::string("identity"), look}) {
        for (const std::vector<std::string>& to :
             {std::vector<std::string>{"--to", "codes"}, {"--display", "Screen"}}) {
            const auto with = [&](std::vector<std::string> words) {
                words.insert(words.end(), {"--ocio-config", config, "--from", "light"});
                words.insert(words.end(), to.begin(), to.end());
                return run(words);
            };
            const json baked = with({"bake", base, "-o", strip, "--engine", "unreal"});
            EXPECT_NE(baked["ocio_config"].get<std::string>().find("from light"),
                      std::string::npos);
            const auto picture = lutlib::io::read_png(contents(strip), "s.png");
            // Node 9 of 16 of blue: its root of light, in codes of 8 bits.
            EXPECT_EQ(picture.at({9 * 16, 0}, 2),
                      std::lround(255 * std::sqrt(9 / 15.0) * (base == look ? .5 : 1)));
            EXPECT_TRUE(with({"verify", strip, "--against", base, "--samples", "50"})["passed"]);
        }
    }
    EXPECT_EQ(lutconv({"bake", look, "-o", strip, "--from", "light"}).exit_code, 3);
    EXPECT_EQ(lutconv({"bake", look, "-o", strip, "--ocio-config", config, "--from", "light",
                       "--to", "codes", "--look-input", "srgb"})
                  .exit_code,
              3);
    EXPECT_EQ(
        lutconv({"edit", "identity", "-o", folder.path("x.cube"), "--view", "Film"}).exit_code, 3);
}

} // namespace
} // namespace converter_test
