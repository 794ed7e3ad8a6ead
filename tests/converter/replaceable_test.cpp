// Nothing that lutconv did not make is written over without --force.
#include "lutlib/io/png.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace converter_test {
namespace {

namespace io = lutlib::io;

io::PngImage small_picture(int seed) {
    io::PngImage out;
    out.width = 96;
    out.height = 64;
    out.srgb_tag = true;
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            for (const int c : {3, 5, 7}) {
                out.samples.push_back(
                    static_cast<std::uint16_t>(40 + (c * x + (8 - c) * y + seed) % 160));
            }
        }
    }
    return out;
}

class Replaceable : public testing::Test {
  protected:
    Replaceable() {
        folder_.write("look.cube", saturated_cube(9));
        folder_.write("small.cube", "LUT_1D_SIZE 2\n0 0 0\n1 0.9 0.8\n");
        folder_.write("before.png", io::write_png(small_picture(0)));
        EXPECT_EQ(
            lutconv_in_process({"apply", in("look.cube"), in("before.png"), "-o", in("after.png")})
                .exit_code,
            0);
        EXPECT_EQ(
            lutconv_in_process({"identity", "--engine", "unity", "-o", in("graded.png")}).exit_code,
            0);
    }
    std::string in(const std::string& name) const { return folder_.path(name); }

    Folder folder_;
};

TEST_F(Replaceable, own_files_are_written_again_and_others_with_force_alone) {
    struct Case {
        std::vector<std::string> words;
        std::string output;
    };
    const std::vector<Case> cases{
        {{"match", in("before.png"), in("after.png"), "--size", "9"}, "made.cube"},
        {{"match", in("before.png"), in("after.png"), "--size", "9"}, "made.spi3d"},
        {{"match", in("before.png"), in("after.png"), "--size", "9"}, "made.3dl"},
        {{"extract", in("graded.png")}, "extracted.cube"},
        {{"identity", "--engine", "unreal", "--into", in("before.png")}, "for_grading.png"},
        {{"show", in("look.cube"), "--panels", "curves"}, "show.png"},
        {{"show", in("look.cube"), "--panels", "curves"}, "show.svg"},
        {{"show", in("look.cube"), "--panels", "curves"}, "show.html"},
        {{"sheet", in("before.png"), in("look.cube")}, "sheet.png"},
        {{"sheet", in("before.png"), in("look.cube")}, "sheet.tif"},
        {{"shader", "--engine", "unreal", "--language", "glsl"}, "lut.glsl"},
        {{"shader", "--inline", in("small.cube"), "--language", "hlsl"}, "inline.hlsl"},
    };
    for (const Case& test : cases) {
        std::vector<std::string> words = test.words;
        words.insert(words.end(), {"-o", in(test.output)});
        const Result first = lutconv_in_process(words);
        ASSERT_EQ(first.exit_code, 0) << test.output << first.err;
        const Result again = lutconv_in_process(words);
        EXPECT_EQ(again.exit_code, 0) << test.output << again.err;
        for (const std::string& foreign :
             {std::string(
                  "TITLE \"Somebody's\"\nLUT_3D_SIZE 2\n0.000 0.000 0.000\n1.000 0.000 0.000\n"
                  "0.000 1.000 0.000\n1.000 1.000 0.000\n0.000 0.000 1.000\n1.000 0.000 "
                  "1.000\n0.000 1.000 1.000\n1.000 1.000 1.000\n"),
              io::write_png(small_picture(9))}) {
            folder_.write(test.output, foreign);
            const Result refused = lutconv_in_process(words);
            EXPECT_EQ(refused.exit_code, 2) << test.output;
            EXPECT_NE(refused.err.find("did not make; name another, or add --force"),
                      std::string::npos)
                << refused.err;
            EXPECT_TRUE(contents(in(test.output)) == foreign) << test.output;
        }
        words.emplace_back("--force");
        EXPECT_EQ(lutconv_in_process(words).exit_code, 0) << test.output;
        folder_.write(test.output, "");
        words.pop_back();
        EXPECT_EQ(lutconv_in_process(words).exit_code, 0) << test.output << ", which was empty";
    }
}

TEST_F(Replaceable, what_a_run_reads_is_refused_even_where_it_is_lutconvs_own) {
    const std::string own = contents(in("graded.png"));
    const Result refused =
        lutconv_in_process({"sheet", in("graded.png"), in("look.cube"), "-o", in("graded.png")});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find("it is what this run reads"), std::string::npos) << refused.err;
    EXPECT_EQ(contents(in("graded.png")), own);
}

} // namespace
} // namespace converter_test
