// What verify may be held against, and what its verdict says.
#include "lutlib/io/file.h"
#include "lutlib/io/png.h"
#include "tests/converter/run_program.h"
#include "tests/support/names.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace converter_test {
namespace {

using lutlib::io::PngImage;
using nlohmann::json;

std::vector<std::string> readable_files() {
    std::vector<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(LUT_TEST_FILES)) {
        if (entry.path().extension() != ".md") {
            out.push_back(entry.path().filename().string());
        }
    }
    std::sort(out.begin(), out.end());
    return out;
}

class BakeFile : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(ReadFiles, BakeFile,
                         testing::ValuesIn(support::rows_to_try(readable_files())),
                         [](const auto& row) { return support::test_name(row.param); });

TEST_P(BakeFile, bakes_what_verify_proves) {
    const Folder folder;
    const std::string look = std::string(LUT_TEST_FILES "/") + GetParam();
    for (const std::string how : {"tetrahedral", "trilinear"}) {
        const std::string picture = folder.path(how + ".png");
        const Result baked = lutconv_in_process(
            {"bake", look, "-o", picture, "--size", "9", "--interpolation", how});
        ASSERT_EQ(baked.exit_code, 0) << baked.err;
        EXPECT_EQ(baked.err.find("sampled onto"), std::string::npos) << baked.err;
        const Result verified =
            lutconv_in_process({"verify", picture, "--against", look, "--samples", "500"});
        EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
    }
}

// OpenColorIO stops at the first comma of a number.
TEST(BakeFile, with_decimal_commas_is_said_and_proved_by_what_lutlib_read) {
    const Folder folder;
    const std::string look = folder.write(
        "comma.cube", "LUT_3D_SIZE 2\n0,1 0 0\n0,9 0 0\n0 0,8 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n"
                      "0,95 0,95 0,95\n");
    const std::string picture = folder.path("x.png");
    const Result baked = lutconv_in_process({"bake", look, "-o", picture});
    ASSERT_EQ(baked.exit_code, 0) << baked.err;
    EXPECT_NE((baked.out + baked.err).find("decimal commas"), std::string::npos);
    const Result verified =
        lutconv_in_process({"verify", picture, "--against", look, "--samples", "500"});
    EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
    EXPECT_NE(verified.out.find("it stops at decimal commas"), std::string::npos) << verified.out;
}

TEST(BakeFile, reads_a_cube_as_the_file_says) {
    const Folder folder;
    const auto clf = [&](const std::string& says) {
        return folder.write("look.clf",
                            "<?xml version=\"1.0\"?>\n<ProcessList compCLFversion=\"3\" id=\"x\">"
                            "<LUT3D inBitDepth=\"32f\" outBitDepth=\"32f\"" +
                                says +
                                "><Array dim=\"2 2 2 3\">\n0 0 0\n0 0 1\n0 1 0\n0 0 0\n1 0 0\n0 0 "
                                "0\n0 0 0\n1 1 1\n</Array></LUT3D></ProcessList>");
    };
    const std::string picture = folder.path("x.png");
    const auto proven = [&](const std::string& look) {
        return lutconv({"bake", look, "-o", picture, "--size", "9"}).exit_code == 0 &&
               lutconv({"verify", picture, "--against", look, "--samples", "500"}).exit_code == 0;
    };
    const auto at_middle = [&](const std::string& look) {
        return lutconv({"eval", look, "0.5", "0.5", "0.5"}).out;
    };
    const std::string trilinear = clf(" interpolation=\"trilinear\"");
    EXPECT_EQ(at_middle(trilinear), "0.25 0.25 0.25\n");
    EXPECT_TRUE(proven(trilinear));
    const std::string silent = clf("");
    EXPECT_EQ(at_middle(silent), "0.5 0.5 0.5\n");
    EXPECT_TRUE(proven(silent));
}

// A strip without a text entry, as another program might have made it.
class Unnamed : public testing::Test {
  protected:
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(17));
    const std::string picture = folder.path("strip.png");

    PngImage baked(const std::vector<std::string>& options) const {
        std::vector<std::string> words{"bake", look, "-o", picture, "--force"};
        words.insert(words.end(), options.begin(), options.end());
        EXPECT_EQ(lutconv(words).exit_code, 0);
        PngImage image = lutlib::io::read_png(contents(picture), "strip.png");
        image.text.clear();
        return image;
    }

    Result verified(const PngImage& image, const std::vector<std::string>& options = {}) const {
        return verified(write_png(image), options);
    }
    Result verified(const std::string& bytes, const std::vector<std::string>& options = {}) const {
        folder.write("strip.png", bytes);
        std::vector<std::string> words{"verify", picture, "--against", look, "--samples", "500"};
        words.insert(words.end(), options.begin(), options.end());
        return lutconv(words);
    }
};

TEST_F(Unnamed, passes_with_the_engine_in_the_verdict) {
    const PngImage swapped = baked({"--engine", "ocio", "--size", "16", "--bits", "8"});
    const Result text = verified(swapped);
    EXPECT_EQ(text.exit_code, 0) << text.out;
    EXPECT_NE(text.out.find("passed as OpenColorIO lut image (ocio), which is what the content "
                            "looks like; for another engine name it with --engine"),
              std::string::npos)
        << text.out;
    const json figures = json::parse(verified(swapped, {"--json"}).out);
    EXPECT_EQ(figures["engine_named_by"], "content");
    EXPECT_NE(figures["verdict"].get<std::string>().find("--engine"), std::string::npos);
    EXPECT_EQ(verified(swapped, {"--engine", "unreal"}).exit_code, 1);

    const json unity =
        json::parse(verified(baked({"--engine", "unity", "--size", "16"}), {"--json"}).out);
    EXPECT_EQ(unity["engine"], "unity");
    EXPECT_EQ(unity["engine_named_by"], "content");
}

TEST_F(Unnamed, fails_when_it_is_not_opaque) {
    PngImage image = baked({});
    const PngImage rgb = image;
    image.channels = 4;
    image.samples.clear();
    for (std::size_t i = 0; i < rgb.samples.size(); i += 3) {
        image.samples.insert(image.samples.end(), &rgb.samples[i], &rgb.samples[i] + 3);
        image.samples.push_back(255);
    }
    EXPECT_EQ(verified(image).exit_code, 0);
    image.at({7, 3}, 3) = 128;
    const Result result = verified(image);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find("1 texels are not opaque"), std::string::npos) << result.out;
}

TEST_F(Unnamed, tells_of_primaries_that_other_loaders_convert_by) {
    std::string bytes = write_png(baked({}));
    constexpr std::size_t behind_header = 33;
    const std::string chrm(
        "\x00\x00\x00\x20\x63\x48\x52\x4d\x00\x00\x7a\x26\x00\x00\x80\x84\x00\x00\xfa\x00\x00\x00"
        "\x80\xe8\x00\x00\x75\x30\x00\x00\xea\x60\x00\x00\x3a\x98\x00\x00\x17\x70\x9c\xba\x51\x3c",
        44);
    bytes.insert(behind_header, chrm);
    const Result result = verified(bytes);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.out.find("cHRM"), std::string::npos) << result.out;
}

TEST_F(Unnamed, is_told_to_name_what_cannot_be_told_from_content) {
    folder.write("a.cube", "LUT_3D_SIZE 2\n0 0 0\n.2 .2 .2\n.7 .7 .7\n.9 .9 .9\n.1 .1 .1\n.3 .3 "
                           ".3\n.8 .8 .8\n1 1 1\n");
    const PngImage mono = baked({});
    const Result untold = verified(mono);
    EXPECT_EQ(untold.exit_code, 2);
    EXPECT_NE(untold.err.find("--engine"), std::string::npos) << untold.err;
    EXPECT_EQ(lutconv({"info", picture}).exit_code, 2);
    const Result layout = lutconv({"info", picture, "--layout", "strip"});
    EXPECT_NE(layout.out.find("layout: strip, 16 nodes"), std::string::npos) << layout.err;
    PngImage named = mono;
    named.text = {{"Engine", "piccolo"}};
    const Result told = verified(named);
    EXPECT_EQ(told.exit_code, 0) << told.out << told.err;
    EXPECT_NE(told.out.find("the engine that the picture names"), std::string::npos) << told.out;
}

TEST(Verify, and_check_say_what_of_the_look_is_not_acted_on) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(3, "LUT_IN_VIDEO_RANGE\n")),
                      strip = folder.path("s.png");
    EXPECT_EQ(lutconv({"bake", look, "-o", strip}).exit_code, 0);
    for (const auto& line : {std::vector<std::string>{"check", look},
                             {"verify", strip, "--against", look, "--samples", "50"}}) {
        const std::string said = lutconv(line).err;
        EXPECT_NE(said.find("not acted on: LUT_IN_VIDEO_RANGE"), std::string::npos) << line[0];
    }
}

TEST(Verify, takes_no_look_that_no_other_verb_takes) {
    const Folder folder;
    const std::string picture = folder.path("x.png");
    const std::string look = folder.write("a.cube", saturated_cube(9));
    ASSERT_EQ(lutconv({"bake", look, "-o", picture, "--size", "9"}).exit_code, 0);
    const auto against = [&](const std::string& path) {
        return lutconv({"verify", picture, "--against", path});
    };
    EXPECT_EQ(against(std::string(TESTS_BAD) + "/nan.cube").exit_code, 2);
    const Result broken = against(folder.write("broken.3dl", "0 512 1023\nnonsense\n"));
    EXPECT_EQ(broken.exit_code, 2);
    EXPECT_EQ(broken.err.find("not a .cube"), std::string::npos) << broken.err;
}

TEST(Verify, evaluates_nearest_itself_because_opencolorio_cannot) {
    const Folder folder;
    const std::string picture = folder.path("x.png");
    const std::string look = folder.write("a.cube", saturated_cube(7));
    ASSERT_EQ(lutconv({"bake", look, "-o", picture, "--interpolation", "nearest", "--size", "16"})
                  .exit_code,
              0);
    const Result result = lutconv({"verify", picture, "--against", look, "--samples", "500"});
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    EXPECT_NE(result.out.find("OpenColorIO has no nearest"), std::string::npos) << result.out;
    const Result other = lutconv(
        {"verify", picture, "--against", look, "--samples", "500", "--interpolation", "trilinear"});
    EXPECT_NE(other.out.find("read with nearest interpolation"), std::string::npos) << other.out;
}

TEST(Recipe, is_a_loss_as_a_table_and_exact_to_eval) {
    const Folder folder;
    const std::string recipe = std::string(SAMPLE_LOOKS) + "/log_to_display.json";
    const std::string table = folder.path("r.cube");
    const Result strict = lutconv({"convert", recipe, "-o", table, "--strict"});
    EXPECT_EQ(strict.exit_code, 2);
    EXPECT_NE(strict.err.find("recipe sampled onto"), std::string::npos) << strict.err;
    EXPECT_FALSE(std::filesystem::exists(table));

    const json said = json::parse(lutconv({"convert", recipe, "-o", table, "--json"}).out);
    const json measured = json::parse(lutconv({"compare", recipe, table, "--json"}).out);
    const double loss = said["losses"][0]["figure"], largest = measured["absolute"]["max"];
    EXPECT_GT(loss, 0.8 * largest);
    EXPECT_LT(loss, 1.2 * largest);

    const Result exact = lutconv({"eval", recipe, "0.1", "0.2", "0.3"});
    EXPECT_EQ(exact.err, "");
    EXPECT_NE(exact.out, lutconv({"eval", table, "0.1", "0.2", "0.3"}).out);
}

TEST(Recipe, is_no_loss_where_a_table_says_it_all) {
    const Folder folder;
    const std::string recipe =
        folder.write("same.json", "{\"schema_version\": 1, \"operators\": []}");
    const Result strict = lutconv({"convert", recipe, "-o", folder.path("r.cube"), "--strict"});
    EXPECT_EQ(strict.exit_code, 0) << strict.err;
}

// A .3dl whose white is far below its depth, and a .vlt: the codes are the file's word, and where
// OpenColorIO takes them for another depth verify says so and proves the picture all the same.
TEST(Verify, says_where_opencolorio_reads_a_file_at_another_scale) {
    const Folder folder;
    std::string rows;
    for (int r = 0; r < 4; ++r) {
        for (int g = 0; g < 4; ++g) {
            for (int b = 0; b < 4; ++b) {
                rows += std::to_string(r * 300) + ' ' + std::to_string(g * 300) + ' ' +
                        std::to_string(b * 250) + '\n';
            }
        }
    }
    const std::string dark =
        folder.write("dark.3dl", "# Output bit depth 12\n0 341 682 1023\n" + rows);
    const std::string vlt = folder.write(
        "a.vlt", "# panasonic vlt file version 1.0\nLUT_3D_SIZE 2\n0 0 0\n4095 0 0\n0 3000 0\n"
                 "4095 3000 0\n0 0 4095\n4095 0 4095\n0 3000 4095\n4095 3000 4095\n");
    const std::string strip = folder.path("s.png");
    EXPECT_EQ(lutconv({"eval", dark, "1", "1", "1"}).out.substr(0, 6), "0.2197");
    for (const auto& [look, times] : {std::pair(dark, "4.003 times"), {vlt, "4095 times"}}) {
        EXPECT_EQ(lutconv({"bake", look, "-o", strip}).exit_code, 0);
        const Result result = lutconv({"verify", strip, "--against", look});
        EXPECT_EQ(result.exit_code, 0) << result.out;
        EXPECT_NE(result.out.find(std::string("OpenColorIO reads ") + times), std::string::npos)
            << result.out;
    }
}

TEST(MistakenFiles, are_refused_by_every_verb_that_reads_looks) {
    const Folder folder;
    const std::string file = folder.write("a.3dl", "{\\rtf1\\ansi 0 0 0}"), out = folder.path("o");
    const std::vector<std::vector<std::string>> lines{{"info", file},
                                                      {"bake", file, "-o", out + ".png"},
                                                      {"convert", file, "-o", out + ".cube"},
                                                      {"check", file},
                                                      {"edit", file, "-o", out + ".cube"},
                                                      {"invert", file, "-o", out + ".cube"},
                                                      {"resample", file, "-o", out + ".cube"},
                                                      {"compare", file, file},
                                                      {"eval", file, "0", "0", "0"}};
    for (const auto& line : lines) {
        const Result result = lutconv(line);
        EXPECT_EQ(result.exit_code, 2) << line[0];
        EXPECT_NE(result.err.find("rich text (RTF)"), std::string::npos) << result.err;
    }
}

} // namespace
} // namespace converter_test
