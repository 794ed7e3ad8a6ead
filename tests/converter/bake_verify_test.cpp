#include "lutlib/bake/budget.h"
#include "lutlib/engine/engine.h"
#include "lutlib/io/file.h"
#include "lutlib/io/png.h"
#include "tests/converter/run_program.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace converter_test {
namespace {

using nlohmann::json;

class BakeEngine : public testing::TestWithParam<lutlib::Engine> {};
INSTANTIATE_TEST_SUITE_P(Engines, BakeEngine,
                         testing::ValuesIn(support::rows_to_try(lutlib::engines())),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(BakeEngine, bakes_what_verify_proves_against_opencolorio) {
    const Folder folder;
    const std::string look = folder.write("my look.CUBE", saturated_cube(17));
    const std::string picture = folder.path("strip.png");
    const std::string engine(GetParam().name);
    const Result baked = lutconv({"bake", look, "-o", picture, "--engine", engine, "--json"});
    ASSERT_EQ(baked.exit_code, 0) << baked.err;
    EXPECT_EQ(json::parse(baked.out)["engine"], engine);

    const lutlib::io::PngImage image = lutlib::io::read_png(contents(picture), "strip.png");
    EXPECT_EQ(image.srgb_tag, GetParam().srgb_tag == lutlib::SrgbTag::present);
    EXPECT_EQ(image.depth.bits, GetParam().default_bits);
    EXPECT_FALSE(image.gamma_tag || image.profile_tag);
    const auto source = std::find_if(image.text.begin(), image.text.end(),
                                     [](const auto& entry) { return entry.first == "Source"; });
    ASSERT_NE(source, image.text.end());
    EXPECT_NE(source->second.find("my look.CUBE"), std::string::npos);

    // The engine is recorded in the picture, so it need not be said.
    const Result verified =
        lutconv({"verify", picture, "--against", look, "--samples", "2000", "--json"});
    EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
    const json figures = json::parse(verified.out);
    EXPECT_EQ(figures["texels"]["wrong"], 0);
    EXPECT_EQ(figures["engine"], engine);
    EXPECT_LT(figures["lookup"]["absolute_error"]["mean"].get<double>(), 0.01);
}

TEST_P(BakeEngine, fits_what_verify_finds_no_worse_than_point_samples) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(17));
    const std::string picture = folder.path("strip.png");
    const std::string engine(GetParam().name);
    // A size that every engine of several takes.
    const bool small = GetParam().sizes.empty();
    const bool fits = small || GetParam().default_size <= lutlib::largest_fitted_size;
    std::vector<std::string> words{"bake", look, "-o", picture, "--engine", engine, "--json"};
    words.push_back("--fit");
    if (small) {
        words.insert(words.end(), {"--size", "16"});
    }
    const Result baked = lutconv(words);
    ASSERT_EQ(baked.exit_code, 0) << baked.err;
    const json figures = json::parse(baked.out);
    EXPECT_EQ(figures.contains("fit"), fits);
    if (fits) {
        EXPECT_LE(figures["fit"]["result"]["mean"], figures["fit"]["point_sampled"]["mean"]);
        EXPECT_LE(figures["fit"]["result"]["max"], figures["fit"]["point_sampled"]["max"]);
    } else {
        EXPECT_FALSE(figures["fitted"]);
        EXPECT_NE(figures["notes"].at(0).get<std::string>().find("beyond 33 nodes"),
                  std::string::npos);
        words.erase(std::find(words.begin(), words.end(), "--json"));
        EXPECT_NE(lutconv(words).out.find("not fitted: beyond 33 nodes"), std::string::npos);
    }
    const Result verified = lutconv({"verify", picture, "--against", look, "--samples", "2000"});
    EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
    EXPECT_EQ(verified.out.find("the lattice is fitted") != std::string::npos, figures["fitted"]);
}

TEST(Verify, finds_the_damage_in_a_fitted_lattice) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(17));
    const std::string picture = folder.path("strip.png");
    ASSERT_EQ(lutconv({"bake", look, "-o", picture, "--size", "9", "--fit"}).exit_code, 0);
    lutlib::io::PngImage image = lutlib::io::read_png(contents(picture), "strip.png");
    for (std::size_t c = 0; c < 3; ++c) {
        image.at({40, 4}, c) = c == 1 ? 0 : 255;
    }
    folder.write("strip.png", write_png(image));
    const Result result = lutconv({"verify", picture, "--against", look, "--samples", "2000"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find("at 40,4"), std::string::npos) << result.out;
}

TEST(Bake, keeps_a_promise_with_the_smallest_lattice_that_can) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(17));
    const std::string picture = folder.path("strip.png");
    const auto within = [&](const char* promise) {
        const Result result =
            lutconv({"bake", look, "-o", picture, "--max-delta-e", promise, "--json"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        const json figures = json::parse(result.out);
        EXPECT_TRUE(figures["budget"]["kept"]);
        // All that is smaller has been tried.
        EXPECT_EQ(figures["budget"]["tried"], figures["size"].get<int>() - 1);
        EXPECT_LE(figures["budget"]["largest"], std::stod(promise));
        EXPECT_LE(figures["delta_e_2000"]["max"], std::stod(promise));
        return figures["size"].get<int>();
    };
    const int loose = within("6"), tight = within("2");
    EXPECT_LT(loose, tight);
    EXPECT_TRUE(std::filesystem::exists(picture));
    // Every size is looked at, not the usual ones alone.
    const Result smaller = lutconv(
        {"bake", look, "-o", picture, "--max-delta-e", "4", "--size", std::to_string(loose - 1)});
    EXPECT_EQ(smaller.exit_code, 1) << smaller.out;
}

TEST(Bake, says_what_a_fit_takes_from_the_look_instead_of_what_point_samples_would) {
    const Folder folder;
    // One that leaves 0..1.
    const std::string look = folder.path("look.cube");
    lutconv(
        {"edit", std::string(SAMPLE_LOOKS) + "/warm_teal.cube", "--saturation", "1.4", "-o", look});
    const auto baked = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"bake", look, "-o", folder.path("x.png"), "--size", "9"};
        words.insert(words.end(), more.begin(), more.end());
        return lutconv(words).out;
    };
    const json point = json::parse(baked({"--json"})),
               fit = json::parse(baked({"--fit", "--json"}));
    ASSERT_TRUE(fit["fitted"]);
    EXPECT_GT(point["loss"]["clamped_values"], 0);
    EXPECT_GT(point["loss"]["max_rounding"], 0);
    EXPECT_EQ(fit["loss"]["clamped_values"], 0);
    EXPECT_EQ(fit["loss"]["max_rounding"], 0);
    EXPECT_EQ(fit["fit"]["look_clamped_values"], point["loss"]["clamped_values"]);
    const std::string text = baked({"--fit"});
    EXPECT_EQ(text.find("lost: rounding"), std::string::npos) << text;
    EXPECT_NE(text.find("the fit aims at the look clamped to 0..1"), std::string::npos) << text;
}

TEST(Bake, says_that_no_combination_keeps_a_promise_and_which_comes_nearest) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(17));
    const std::string picture = folder.path("strip.png");
    const Result result =
        lutconv({"bake", look, "-o", picture, "--engine", "unreal", "--max-delta-e", "0.01"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find("no combination stays within"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("the closest is"), std::string::npos) << result.out;
    EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST(Bake, writes_the_same_picture_whether_it_measures_or_not_and_says_which) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(9));
    const Result measured = lutconv({"bake", look, "-o", folder.path("a.png"), "--measure"});
    const Result unmeasured = lutconv({"bake", look, "-o", folder.path("b.png")});
    EXPECT_EQ(unmeasured.exit_code, 0) << unmeasured.err;
    EXPECT_EQ(contents(folder.path("a.png")), contents(folder.path("b.png")));
    EXPECT_NE(measured.out.find("dE2000: p99"), std::string::npos);
    EXPECT_EQ(measured.out.find("not measured"), std::string::npos);
    EXPECT_EQ(unmeasured.out.find("dE2000"), std::string::npos);
    EXPECT_NE(unmeasured.out.find("rounding"), std::string::npos);
    EXPECT_NE(unmeasured.out.find("not measured"), std::string::npos);
    const auto figures = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"bake", look, "-o", folder.path("c.png"), "--json"});
        return json::parse(lutconv(more).out);
    };
    EXPECT_TRUE(figures({}).contains("delta_e_2000"));
    EXPECT_FALSE(figures({"--no-measure"}).contains("delta_e_2000"));
    EXPECT_EQ(
        lutconv({"bake", look, "-o", folder.path("c.png"), "--no-measure", "--fit"}).exit_code, 3);
}

TEST(Bake, reads_standard_input_and_writes_standard_output) {
    const Folder folder;
    const std::string look = saturated_cube(9);
    const Result piped = lutconv({"bake", "-", "-o", "-"}, look);
    ASSERT_EQ(piped.exit_code, 0) << piped.err;
    EXPECT_TRUE(lutlib::io::is_png(piped.out));
    EXPECT_NE(piped.err.find("standard input"), std::string::npos);
    const std::string picture = folder.write("strip.png", piped.out);
    EXPECT_EQ(lutconv({"verify", picture, "--against", "-"}, look).exit_code, 0);
}

TEST(Bake, says_what_an_engine_cannot_reach) {
    const Folder folder;
    const std::string wide =
        folder.write("hdr.cube", saturated_cube(9, "DOMAIN_MIN 0 0 0\nDOMAIN_MAX 4 4 4\n"));
    const Result result = lutconv({"bake", wide, "-o", folder.path("x.png")});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.out.find("reaches 25 % of the look's input domain (0..4)"), std::string::npos)
        << result.out;
}

TEST(Verify, fails_with_words_when_another_tool_swapped_the_slices) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(17));
    const std::string picture = folder.path("strip.png");
    // ociolutimage's layout at 16 nodes has Unreal's dimensions with green and blue swapped.
    ASSERT_EQ(
        lutconv({"bake", look, "-o", picture, "--engine", "ocio", "--size", "16", "--bits", "8"})
            .exit_code,
        0);
    const Result result = lutconv({"verify", picture, "--against", look, "--engine", "unreal"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find("green and blue are swapped"), std::string::npos) << result.out;
}

TEST(Verify, fails_with_words_on_a_wrong_size_and_a_wrong_tag) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(17));
    const std::string picture = folder.path("strip.png");
    ASSERT_EQ(lutconv({"bake", look, "-o", picture, "--size", "33"}).exit_code, 0);
    lutlib::io::PngImage image = lutlib::io::read_png(contents(picture), "strip.png");
    image.srgb_tag = true;
    folder.write("strip.png", write_png(image));
    const Result result = lutconv({"verify", picture, "--against", look, "--engine", "unreal"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find("unreal takes a lattice of size 16, not 33"), std::string::npos);
    EXPECT_NE(result.out.find("the chunk sRGB"), std::string::npos) << result.out;
    const Result tiles = lutconv({"verify", picture, "--against", look, "--engine", "obs"});
    EXPECT_EQ(tiles.exit_code, 1);
    EXPECT_NE(tiles.out.find("wrong size"), std::string::npos) << tiles.out;
}

// The chunk of a PNG, put behind its header.
std::string with_gamma(std::string png) {
    const std::string chunk = std::string("gAMA") + std::string("\0\0\xb1\x8f", 4); // 0.45455
    std::uint32_t crc = 0xffffffffU;
    for (const char byte : chunk) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1) ^ ((crc & 1) ? 0xedb88320U : 0);
        }
    }
    crc = ~crc;
    std::string bytes = std::string("\0\0\0\4", 4) + chunk;
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(crc >> shift & 0xff);
    }
    constexpr std::size_t behind_header = 33;
    return png.insert(behind_header, bytes);
}

TEST(Verify, says_so_when_only_a_chunk_is_wrong_and_convert_takes_it_out) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(17));
    const std::string picture = folder.path("strip.png");
    ASSERT_EQ(lutconv({"bake", look, "-o", picture, "--engine", "unity"}).exit_code, 0);
    const std::string clean = contents(picture);
    folder.write("strip.png", with_gamma(clean));
    const Result result = lutconv({"verify", picture, "--against", look, "--engine", "unity"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find("why: the texels are right; the PNG carries gAMA, by which Unity"),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("--strip-tags"), std::string::npos);
    const std::string stripped = folder.path("stripped.png");
    ASSERT_EQ(lutconv({"convert", picture, "-o", stripped, "--strip-tags"}).exit_code, 0);
    EXPECT_EQ(lutconv({"verify", stripped, "--against", look, "--engine", "unity"}).exit_code, 0);
    EXPECT_EQ(lutlib::io::read_png(contents(stripped), "").samples,
              lutlib::io::read_png(clean, "").samples);
}

TEST(Verify, passes_with_a_note_where_the_engine_ignores_the_chunk) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(17));
    const std::string picture = folder.path("strip.png");
    ASSERT_EQ(lutconv({"bake", look, "-o", picture}).exit_code, 0);
    folder.write("strip.png", with_gamma(contents(picture)));
    const Result result = lutconv({"verify", picture, "--against", look, "--engine", "piccolo"});
    EXPECT_EQ(result.exit_code, 0) << result.out;
    EXPECT_NE(result.out.find("note: the PNG carries gAMA, which Piccolo / Pilot ignores"),
              std::string::npos)
        << result.out;
}

TEST(Bake, offers_no_size_that_the_engine_would_ignore) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(9));
    const Result result = lutconv(
        {"bake", look, "-o", folder.path("s.png"), "--engine", "unity", "--max-delta-e", "40"});
    EXPECT_EQ(result.exit_code, 0) << result.out;
    EXPECT_NE(result.out.find("32 nodes per axis"), std::string::npos) << result.out;
}

TEST(Verify, names_the_interpolation_when_that_is_the_difference) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(9));
    const std::string picture = folder.path("strip.png");
    ASSERT_EQ(lutconv({"bake", look, "-o", picture, "--interpolation", "trilinear"}).exit_code, 0);
    EXPECT_EQ(lutconv({"verify", picture, "--against", look}).exit_code, 0);
    const Result result =
        lutconv({"verify", picture, "--against", look, "--interpolation", "tetrahedral"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find("trilinear interpolation"), std::string::npos) << result.out;
}

std::vector<std::filesystem::path> cubes_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> out;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (lutlib::io::extension_of(entry.path().string()) == "cube") {
            out.push_back(entry.path());
        }
    }
    return out;
}

TEST(Verify, holds_a_bake_of_a_recipe_against_the_recipe_itself) {
    const Folder folder;
    const std::string picture = folder.path("strip.png"), looks = SAMPLE_LOOKS;
    ASSERT_EQ(lutconv({"bake", looks + "/warm_teal.json", "-o", picture}).exit_code, 0);
    const auto against = [&](const std::string& recipe) {
        return lutconv({"verify", picture, "--against", looks + recipe, "--samples", "1000"});
    };
    const Result right = against("/warm_teal.json");
    EXPECT_EQ(right.exit_code, 0) << right.out;
    EXPECT_NE(right.out.find("the recipe, evaluated exactly"), std::string::npos) << right.out;
    EXPECT_EQ(against("/bleach_bypass.json").exit_code, 1);
}

TEST(SampleLooks, lie_beside_strips_that_verify) {
    const std::vector<std::filesystem::path> looks = cubes_in(SAMPLE_LOOKS);
    EXPECT_GE(looks.size(), 4U);
    for (std::filesystem::path look : looks) {
        const std::string cube = look.string(), strip = look.replace_extension("png").string();
        const Result verified = lutconv({"verify", strip, "--against", cube, "--samples", "1000"});
        EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
    }
}

TEST(RealLooks, bake_and_verify_for_every_engine) {
    if (std::string(EXTRA_DATA).empty()) {
        GTEST_SKIP() << "the CMake option LUT_EXTRA_DATA names no folder with further looks";
    }
    const Folder scratch;
    // Every look and every engine; each of one with each of the others where all are asked for.
    const std::size_t step = support::is_thorough() ? 1 : 3;
    std::size_t turn = 0;
    for (const std::filesystem::path& look : cubes_in(std::filesystem::path(EXTRA_DATA) / "luts")) {
        const std::size_t first = turn++ % step;
        for (std::size_t i = first; i < lutlib::engines().size(); i += step) {
            const lutlib::Engine& engine = lutlib::engines()[i];
            const std::string picture = scratch.path("x.png");
            const std::string name(engine.name);
            ASSERT_EQ(lutconv({"bake", look.string(), "-o", picture, "--engine", name}).exit_code,
                      0);
            const Result verified =
                lutconv({"verify", picture, "--against", look.string(), "--samples", "1000"});
            EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
        }
    }
}

} // namespace
} // namespace converter_test
