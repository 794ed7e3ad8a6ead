// Nothing that lutconv did not make is written over without --force.
#include "lutlib/io/image.h"
#include "lutlib/io/png.h"
#include "tests/converter/run_program.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
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
        io::write_image(in("plate.exr"), io::read_image(in("before.png")),
                        {.depth = io::Depth::half, .text = {{"Software", "Another"}}});
        std::filesystem::create_directory(in("looks"));
        folder_.write("looks/after.cube", saturated_cube(5));
    }
    std::string in(const std::string& name) const { return folder_.path(name); }

    Folder folder_;
};

// Behind a verb's words stands the option for the file.
struct Case {
    std::vector<std::string> words;
    std::string output, option = "-o";
};

class EveryWritingVerb : public Replaceable {
  protected:
    std::map<std::string, std::vector<Case>> cases() const {
        const std::string look = in("look.cube"), before = in("before.png"), x = in("x.cube");
        const Case matched{{before, in("after.png"), "--size", "9"}, "made.cube"};
        const std::vector<std::string> shown{look, "--panels", "curves"},
            reported{look, "--sizes", "2", "3"}, mixed{look, look, "--size", "9"},
            exposed{look, "--exposure", "0.1"};
        const auto with = [](std::vector<std::string> words, const std::vector<std::string>& more) {
            words.insert(words.end(), more.begin(), more.end());
            return words;
        };
        return {
            {"bake",
             {{{look}, "bake.png"},
              {{look, look, "--stack"}, "stack.png"},
              {{in("looks"), "--engine", "unity"}, "{name}.bake.png"}}},
            {"check", {{{look, "--repair", "--clamp"}, "check.cube"}}},
            {"convert",
             {{{look}, "convert.cube"},
              {{look}, "convert.spi3d"},
              {{look}, "convert.3dl"},
              {{look}, "convert.csp"},
              {{look}, "convert.clf"},
              {{look}, "convert.png"},
              {{in("graded.png"), "--strip-tags"}, "stripped.png"},
              {{in("looks")}, "{name}.convert.cube"}}},
            {"edit",
             {{exposed, "edit.cube"},
              {with(exposed, {"-o", x}), "recipe.json", "--save-recipe"},
              {with(exposed, {"-o", x, "--cdl-saturation", "2"}), "one.cc", "--save-cdl"},
              {with(exposed, {"-o", x, "--cdl-saturation", "2"}), "many.ccc", "--save-cdl"},
              {with(exposed, {"-o", x, "--cdl-saturation", "2"}), "list.cdl", "--save-cdl"}}},
            {"resample", {{{look, "--size", "5"}, "resample.cube"}}},
            {"compose", {{mixed, "compose.cube"}}},
            {"invert", {{{look, "--size", "5"}, "invert.cube"}}},
            {"blend", {{mixed, "blend.cube"}}},
            {"match",
             {matched,
              {matched.words, "made.spi3d"},
              {matched.words, "made.3dl"},
              {with(matched.words, {"-o", x}), "match.html", "--html"}}},
            {"extract",
             {{{in("graded.png")}, "extracted.cube"},
              {{in("graded.png"), "--engine", "unity"}, "extracted.png"}}},
            {"apply",
             {{{look, before}, "apply.png"},
              {{look, before}, "apply.exr"},
              {{look, before}, "apply.tif"},
              {{look, before}, "apply.jpg"},
              {{look, in("plate.exr")}, "graded.exr"},
              {{look, before, in("after.png")}, "{name}.apply.png"}}},
            {"identity",
             {{{"--size", "5"}, "identity.cube"},
              {{"--engine", "unity"}, "identity.png"},
              {{"--engine", "unreal", "--into", before}, "for_grading.png"}}},
            {"show", {{shown, "show.png"}, {shown, "show.svg"}, {shown, "show.html"}}},
            {"sheet", {{{before, look}, "sheet.png"}, {{before, look}, "sheet.tif"}}},
            {"shader",
             {{{"--engine", "unreal", "--language", "glsl"}, "lut.glsl"},
              {{"--inline", in("small.cube"), "--language", "hlsl"}, "inline.hlsl"}}},
            {"report",
             {{reported, "report.html"},
              {with(reported, {"-o", in("x.html")}), "report.json", "--json"},
              {with(reported, {"-o", in("x.html")}), "report.csv", "--csv"}}},
        };
    }
    // What the template names.
    static std::string made_by(std::string output) {
        const std::size_t field = output.find("{name}");
        return field == std::string::npos ? output : output.replace(field, 6, "after");
    }
};

TEST_F(EveryWritingVerb, takes_force_and_is_tried_here) {
    const auto all = cases();
    for (const std::string& verb : verbs()) {
        const std::string help = lutconv_in_process({verb, "--help"}).out;
        const bool writes = help.find("--output") != std::string::npos;
        EXPECT_EQ(help.find("--force") != std::string::npos, writes) << verb;
        EXPECT_EQ(all.contains(verb), writes) << verb;
    }
}

TEST_F(EveryWritingVerb, replaces_own_files_and_others_with_force_alone) {
    for (const auto& [verb, tried] : support::rows_to_try(cases())) {
        for (const Case& test : tried) {
            SCOPED_TRACE(verb + " " + test.option + " " + test.output);
            const std::string output = made_by(test.output);
            std::vector<std::string> words{verb};
            words.insert(words.end(), test.words.begin(), test.words.end());
            words.insert(words.end(), {test.option, in(test.output)});
            const Result first = lutconv_in_process(words);
            ASSERT_LE(first.exit_code, 1) << first.err;
            ASSERT_FALSE(contents(in(output)).empty());
            const Result again = lutconv_in_process(words);
            EXPECT_EQ(again.exit_code, first.exit_code) << again.err;
            for (const std::string& foreign :
                 {std::string(
                      "TITLE \"Somebody's\"\nLUT_3D_SIZE 2\n0.000 0.000 0.000\n1.000 0.000 "
                      "0.000\n0.000 1.000 0.000\n1.000 1.000 0.000\n0.000 0.000 1.000\n1.000 "
                      "0.000 1.000\n0.000 1.000 1.000\n1.000 1.000 1.000\n"),
                  std::string("{\"schema_version\":1,\"operators\":[]}"),
                  io::write_png(small_picture(9))}) {
                folder_.write(output, foreign);
                const Result refused = lutconv_in_process(words);
                EXPECT_EQ(refused.exit_code, 2);
                EXPECT_NE(refused.err.find("did not make; name another, or add --force"),
                          std::string::npos)
                    << refused.err;
                EXPECT_TRUE(contents(in(output)) == foreign);
            }
            words.emplace_back("--force");
            EXPECT_EQ(lutconv_in_process(words).exit_code, first.exit_code);
            folder_.write(output, "");
            words.pop_back();
            EXPECT_EQ(lutconv_in_process(words).exit_code, first.exit_code) << "over an empty file";
        }
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
