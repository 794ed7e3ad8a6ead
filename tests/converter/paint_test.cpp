// A screenshot on its way through a paint program and back: identity --into, a grade, extract.
#include "lutlib/io/png.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace converter_test {
namespace {

using nlohmann::json;
namespace io = lutlib::io;

class Paint : public testing::Test {
  protected:
    Paint() {
        io::PngImage shot;
        shot.width = 320;
        shot.height = 120;
        for (int y = 0; y < shot.height; ++y) {
            for (int x = 0; x < shot.width; ++x) {
                for (const int code : {x * 4 / 5, 2 * y, (x * y / 40 + (x > 150 ? 60 : 0)) % 256}) {
                    shot.samples.push_back(static_cast<std::uint16_t>(code % 256));
                }
            }
        }
        folder_.write("shot.png", io::write_png(shot));
        folder_.write("grade.cube", saturated_cube(17));
    }

    std::string in(const std::string& name) const { return folder_.path(name); }
    // Places a strip, grades all and returns the graded picture's path.
    std::string graded(const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{"identity", "--into", in("shot.png"), "-o",
                                       in("placed.png")};
        words.insert(words.end(), more.begin(), more.end());
        const Result placed = lutconv_in_process(words);
        EXPECT_EQ(placed.exit_code, 0) << placed.err;
        const Result applied = lutconv_in_process(
            {"apply", in("grade.cube"), in("placed.png"), "-o", in("graded.png")});
        EXPECT_EQ(applied.exit_code, 0) << applied.err;
        return in("graded.png");
    }
    io::PngImage read(const std::string& name) const {
        return io::read_png(contents(in(name)), name);
    }

    Folder folder_;
};

TEST_F(Paint, a_grade_comes_back_as_a_look_whose_distance_is_said) {
    for (const std::string engine : {"unreal", "unity", "ocio"}) {
        const std::string picture = graded({"--engine", engine});
        const Result result = lutconv_in_process(
            {"extract", picture, "-o", in("look.cube"), "--original", in("shot.png"), "--json"});
        ASSERT_EQ(result.exit_code, 0) << result.err << result.out;
        const json said = json::parse(result.out);
        EXPECT_TRUE(said["strip"]["marked"]);
        EXPECT_TRUE(said["harms"].empty()) << said["harms"];
        EXPECT_TRUE(said["on_original"]["edits"].empty()) << said["on_original"]["edits"];
        EXPECT_EQ(said["on_original"]["delta_e_2000"]["count"], 320 * 120);
        // Codes of 8 bits, of the strip and of the picture.
        EXPECT_LT(said["on_original"]["delta_e_2000"]["mean"], 0.5);
        const json far = json::parse(
            lutconv_in_process({"compare", in("look.cube"), in("grade.cube"), "--json"}).out);
        // 16 nodes of the 17 of a look with kinks; of 8 bits.
        EXPECT_LT(far["absolute"]["p95"], 2.5 / 255) << engine;
    }
}

TEST_F(Paint, the_screenshot_lies_beside_the_strip_as_it_was) {
    for (const std::string place : {"below", "right"}) {
        ASSERT_EQ(lutconv_in_process({"identity", "--into", in("shot.png"), "--place", place, "-o",
                                      in("placed.png")})
                      .exit_code,
                  0);
        const io::PngImage shot = read("shot.png"), placed = read("placed.png");
        EXPECT_EQ(place == "below", placed.height > shot.height);
        for (int y = 0; y < shot.height; y += 7) {
            for (int x = 0; x < shot.width; x += 3) {
                for (std::size_t c = 0; c < 3; ++c) {
                    ASSERT_EQ(placed.at({x, y}, c), shot.at({x, y}, c));
                }
            }
        }
        const json said = json::parse(
            lutconv_in_process({"extract", in("placed.png"), "-o", in("look.cube"), "--json"}).out);
        ASSERT_EQ(said["harms"].size(), 1U);
        EXPECT_EQ(said["harms"][0]["name"], "neutral");
    }
}

TEST_F(Paint, a_strip_becomes_any_engine_s_picture_that_verify_proves) {
    const std::string picture = graded({"--engine", "unity"});
    ASSERT_EQ(lutconv_in_process({"extract", picture, "-o", in("look.cube")}).exit_code, 0);
    // One that feeds sRGB, and one for which that is converted.
    for (const std::string engine : {"unity", "o3de"}) {
        const std::string strip = in(engine + ".png");
        const Result made =
            lutconv_in_process({"extract", picture, "--engine", engine, "-o", strip});
        ASSERT_EQ(made.exit_code, 0) << made.err;
        EXPECT_EQ(made.out.find("is converted to srgb") != std::string::npos, engine == "o3de")
            << made.out;
        const Result proof =
            lutconv_in_process({"verify", strip, "--against", in("look.cube"), "--engine", engine});
        EXPECT_EQ(proof.exit_code, 0) << proof.out << proof.err;
    }
}

TEST_F(Paint, refuses_with_one_sentence_and_exit_code_2) {
    const auto refused = [&](const std::vector<std::string>& words, const std::string& says) {
        const Result result = lutconv_in_process(words);
        EXPECT_EQ(result.exit_code, 2) << result.out;
        EXPECT_NE(result.err.find(says), std::string::npos) << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    };
    const std::string picture = graded();
    refused({"extract", in("shot.png"), "-o", in("x.cube")}, "no neutral strip was found");
    io::PngImage two = read("graded.png");
    const std::vector<std::uint16_t> once = two.samples;
    two.samples.insert(two.samples.end(), once.begin(), once.end());
    two.height *= 2;
    folder_.write("two.png", io::write_png(two));
    refused({"extract", in("two.png"), "-o", in("x.cube")}, "it holds 2 strips");
    EXPECT_EQ(lutconv_in_process({"extract", in("two.png"), "-o", in("x.cube"), "--around",
                                  "30," + std::to_string(read("graded.png").height + 170)})
                  .exit_code,
              0);
    refused({"identity", "--into", in("shot.png"), "--place", "top-left", "--engine", "unity", "-o",
             in("y.png")},
            "must not be scaled");
    folder_.write("small.png", [&] {
        io::PngImage small = read("shot.png");
        small.height = 60;
        small.samples.resize(static_cast<std::size_t>(small.width) * 60 * 3);
        return io::write_png(small);
    }());
    refused({"extract", picture, "-o", in("z.cube"), "--original", in("small.png")},
            "give the screenshot");
}

TEST_F(Paint, overwrites_no_picture_of_somebody_else_without_force) {
    const std::string before = contents(in("shot.png"));
    const std::vector<std::string> over{"identity", "--into", in("shot.png"), "-o", in("shot.png")};
    EXPECT_EQ(lutconv_in_process(over).exit_code, 2);
    EXPECT_EQ(contents(in("shot.png")), before);
    const std::string picture = graded();
    // Its own it replaces.
    graded();
    folder_.write("theirs.png", before);
    const std::vector<std::string> heat{"extract",    picture,        "-o",     in("look.cube"),
                                        "--original", in("shot.png"), "--heat", in("theirs.png")};
    EXPECT_EQ(lutconv_in_process(heat).exit_code, 2);
    EXPECT_EQ(contents(in("theirs.png")), before);
    std::vector<std::string> forced = heat;
    forced.emplace_back("--force");
    EXPECT_EQ(lutconv_in_process(forced).exit_code, 0);
    EXPECT_NE(contents(in("theirs.png")), before);
}

TEST_F(Paint, what_is_not_whole_is_named_and_written_only_when_asked) {
    graded();
    io::PngImage picture = read("graded.png");
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                std::uint16_t& code = picture.at({x, y}, c);
                code = static_cast<std::uint16_t>(code * (400 + x) / 800);
            }
        }
    }
    folder_.write("shaded.png", io::write_png(picture));
    const Result result =
        lutconv_in_process({"extract", in("shaded.png"), "-o", in("shaded.cube")});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE((result.out + result.err).find("not whole: the border"), std::string::npos)
        << result.out << result.err;
    const std::vector<std::string> names = folder_.names();
    EXPECT_EQ(std::count(names.begin(), names.end(), "shaded.cube"), 0);
    EXPECT_EQ(
        lutconv_in_process({"extract", in("shaded.png"), "-o", in("shaded.cube"), "--damaged"})
            .exit_code,
        0);
}

TEST_F(Paint, a_jpeg_is_read_said_and_denoised) {
    graded();
    ASSERT_EQ(lutconv_in_process({"identity", "-o", in("id.cube")}).exit_code, 0);
    ASSERT_EQ(lutconv_in_process({"apply", in("id.cube"), in("graded.png"), "-o", in("graded.jpg")})
                  .exit_code,
              0);
    const Result result = lutconv_in_process(
        {"extract", in("graded.jpg"), "-o", in("look.cube"), "--denoise", "--damaged", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err << result.out;
    const json said = json::parse(result.out);
    EXPECT_NE(said["harms"].dump().find("\"lossy\""), std::string::npos) << said["harms"];
    EXPECT_GT(said["denoised"]["moved"], 1000);
    EXPECT_GT(said["denoised"]["delta_e_2000"]["mean"], 0);
}

TEST_F(Paint, a_strip_cut_out_by_hand_is_found_by_its_content) {
    ASSERT_EQ(lutconv_in_process({"bake", in("grade.cube"), "-o", in("strip.png")}).exit_code, 0);
    io::PngImage picture = read("shot.png");
    const io::PngImage strip = read("strip.png");
    for (int y = 0; y < strip.height; ++y) {
        for (int x = 0; x < strip.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                picture.at({x + 41, y + 53}, c) = strip.at({x, y}, c);
            }
        }
    }
    folder_.write("pasted.png", io::write_png(picture));
    const Result result =
        lutconv_in_process({"extract", in("pasted.png"), "-o", in("look.cube"), "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err << result.out;
    const json said = json::parse(result.out);
    EXPECT_FALSE(said["strip"]["marked"]);
    EXPECT_EQ(said["strip"]["x"], 41);
    EXPECT_EQ(said["strip"]["y"], 53);
}

TEST_F(Paint, stacked_lattices_are_each_what_a_bake_makes_by_itself) {
    folder_.write("other.cube", saturated_cube(9));
    const Result result = lutconv_in_process(
        {"bake", in("grade.cube"), in("other.cube"), "--stack", "-o", in("multi.png")});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const io::PngImage multi = read("multi.png");
    EXPECT_EQ(multi.width, 1024);
    EXPECT_EQ(multi.height, 64);
    int row = 0;
    for (const std::string name : {"grade.cube", "other.cube"}) {
        ASSERT_EQ(
            lutconv_in_process({"bake", in(name), "--engine", "reshade", "-o", in("alone.png")})
                .exit_code,
            0);
        const io::PngImage alone = read("alone.png");
        const std::size_t first = static_cast<std::size_t>(row) * alone.samples.size();
        EXPECT_TRUE(std::equal(alone.samples.begin(), alone.samples.end(),
                               multi.samples.begin() + static_cast<std::ptrdiff_t>(first)));
        ++row;
    }
    EXPECT_EQ(lutconv_in_process(
                  {"bake", in("grade.cube"), "--stack", "--engine", "unity", "-o", in("x.png")})
                  .exit_code,
              3);
}

} // namespace
} // namespace converter_test
