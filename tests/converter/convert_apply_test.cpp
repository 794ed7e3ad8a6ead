#include "tests/converter/run_program.h"
#include "tests/support/thorough.h"

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/image.h"
#include "lutlib/io/look.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>

namespace converter_test {
namespace {

namespace io = lutlib::io;
using nlohmann::json;

constexpr const char* hdr_head = "DOMAIN_MIN 0 0 0\nDOMAIN_MAX 4 4 4\n";

TEST(Convert, goes_both_ways_between_a_cube_and_every_format_that_is_read_and_written) {
    const Folder folder;
    const std::string look = folder.write("my look.cube", saturated_cube(16));
    for (const lutlib::FileFormat* const row : io::file_formats()) {
        const lutlib::FileFormat& format = *row;
        if (format.read && format.write && format.holds.cube) {
            const std::string there = folder.path("there." + format.extensions.first());
            const std::string back = folder.path("back.cube");
            const Result first =
                lutconv({"convert", look, "-o", there, "--format", std::string(format.name)});
            ASSERT_EQ(first.exit_code, 0) << format.name << first.err;
            const Result second =
                lutconv({"convert", there, "--from", std::string(format.name), "-o", back});
            ASSERT_EQ(second.exit_code, 0) << format.name << second.err;
            const lutlib::Lut before = io::read_lut(look).lut, after = io::read_lut(back).lut;
            const double step = format.holds.integer_bits ? 1.0 / 4095 : 1e-6;
            for (std::size_t i = 0; i < before.cube->nodes.size(); ++i) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const float meant = before.cube->nodes[i][c];
                    const float kept =
                        format.holds.integer_bits ? std::min(std::max(meant, 0.0F), 1.0F) : meant;
                    ASSERT_NEAR(after.cube->nodes[i][c], kept, step) << format.name << ' ' << i;
                }
            }
        }
    }
}

TEST(Convert, says_what_a_format_cannot_hold_and_refuses_it_under_strict) {
    const Folder folder;
    const std::string look = folder.write("hdr.cube", saturated_cube(9, hdr_head));
    const std::string out = folder.path("out.spi3d");
    const Result strict = lutconv({"convert", look, "-o", out, "--strict"});
    EXPECT_EQ(strict.exit_code, 2);
    EXPECT_NE(strict.err.find("input 0..4 cut to 0..1: 3 units of input"), std::string::npos)
        << strict.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"hdr.cube"}));
    const Result said = lutconv({"convert", look, "-o", out, "--json"});
    ASSERT_EQ(said.exit_code, 0) << said.err;
    const json figures = json::parse(said.out);
    EXPECT_EQ(figures["format"], "spi3d");
    EXPECT_EQ(figures["losses"][0]["what"], "input 0..4 cut to 0..1");
    EXPECT_EQ(figures["losses"][0]["figure"], 3);
}

TEST(Convert, keeps_a_domain_of_4_where_the_format_can) {
    const Folder folder;
    const std::string look = folder.write("hdr.cube", saturated_cube(9, hdr_head));
    for (const char* name : {"x.csp", "x.clf", "x.ctf", "x.cube"}) {
        const Result result = lutconv({"convert", look, "-o", folder.path(name), "--strict"});
        EXPECT_EQ(result.exit_code, 0) << name << result.err;
        EXPECT_EQ(io::read_lut(folder.path(name)).lut.domain().max.r, 4) << name;
    }
}

TEST(Convert, pipes) {
    const Folder folder;
    const std::string cube = saturated_cube(9);
    const Result csp = lutconv({"convert", "-", "-o", "-", "--format", "csp"}, cube);
    ASSERT_EQ(csp.exit_code, 0) << csp.err;
    EXPECT_EQ(csp.out.rfind("CSPLUTV100", 0), 0U);
    EXPECT_NE(csp.err.find("nothing was lost"), std::string::npos) << csp.err;
    const Result back = lutconv({"convert", "-", "-o", "-"}, csp.out);
    ASSERT_EQ(back.exit_code, 0) << back.err;
    EXPECT_EQ(io::decode_lut(back.out, "x.cube").lut.cube, io::decode_lut(cube, "x.cube").lut.cube);
}

TEST(Convert, calls_unknown_formats_and_extensions_bad_usage) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(5));
    EXPECT_EQ(lutconv({"convert", look, "-o", folder.path("x.unknown")}).exit_code, 3);
    EXPECT_EQ(lutconv({"convert", look, "-o", folder.path("x.cube"), "--format", "no"}).exit_code,
              3);
    EXPECT_EQ(
        lutconv({"convert", look, "-o", folder.path("x.png"), "--format", "hald", "--size", "33"})
            .exit_code,
        3);
    EXPECT_EQ(lutconv({"convert", look, "-o", folder.path("x.cc")}).exit_code, 3);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.cube"}));
}

TEST(Convert, from_cube_to_png_loads_neither_opencolorio_nor_openimageio) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(16));
    ::setenv("LD_DEBUG", "libs", 1);
    const auto converted = [&](const char* to) {
        return lutconv_process({"convert", look, "-o", folder.path(to), "--no-sandbox"});
    };
    const Result picture = converted("x.png"), other = converted("x.clf");
    ::unsetenv("LD_DEBUG");
    ASSERT_EQ(picture.exit_code, 0);
    EXPECT_EQ(picture.err.find("OpenColorIO"), std::string::npos);
    EXPECT_EQ(picture.err.find("OpenImageIO"), std::string::npos);
    EXPECT_NE(other.err.find("OpenColorIO"), std::string::npos) << "the test sees no libraries";
}

io::FloatImage ramp(float from, float to) {
    io::FloatImage image;
    image.width = 64;
    image.height = 4;
    for (int i = 0; i < 256; ++i) {
        const float t = from + (to - from) * static_cast<float>(i) / 255;
        for (const float v : {t, from + to - t, t * t, 0.25F}) {
            image.rgba.push_back(v);
        }
    }
    return image;
}

struct Route {
    std::string in, out;
    io::Depth depth;
    double tolerance;
};

class ApplyRoute : public testing::TestWithParam<Route> {};
INSTANTIATE_TEST_SUITE_P(Apply, ApplyRoute,
                         testing::Values(Route{"a.png", "b.png", io::Depth::uint16, 0.5 / 65535},
                                         Route{"a.png", "b.exr", io::Depth::float32, 0},
                                         Route{"a.exr", "b.exr", io::Depth::float32, 0},
                                         Route{"a.exr", "b.png", io::Depth::uint16, 0.5 / 65535}),
                         [](const auto& row) {
                             return row.param.in.substr(2) + "_to_" + row.param.out.substr(2);
                         });

TEST(Apply, partial_grades_what_is_there_and_says_how_much) {
    if (support::is_sanitized) {
        GTEST_SKIP() << "OpenImageIO takes megabytes for each row, which a sanitizer fills";
    }
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(5));
    const std::string picture = folder.path("a.exr"), out = folder.path("b.exr");
    io::FloatImage image;
    image.width = 16;
    image.height = 64;
    image.rgba.assign(4 * image.pixels(), 0.5F);
    io::write_image(picture, image, {io::Depth::float32, true, {}});
    const std::string whole = contents(picture);
    folder.write("a.exr", whole.substr(0, whole.size() - 40)); // within the last rows
    EXPECT_EQ(lutconv({"apply", look, picture, "-o", out}).exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(out));
    const Result part = lutconv({"apply", look, picture, "-o", out, "--partial"});
    ASSERT_EQ(part.exit_code, 0) << part.err;
    EXPECT_NE(part.out.find(" % of the picture is in its file"), std::string::npos) << part.out;
    const io::FloatImage graded = io::read_image(out);
    EXPECT_NE(graded.rgba[0], graded.rgba[4 * (graded.pixels() - 1)]);
}

TEST_P(ApplyRoute, evaluates_the_lut_at_every_pixel_and_keeps_alpha) {
    const Route& route = GetParam();
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(9));
    const bool png = route.in == "a.png";
    io::write_image(folder.path(route.in), ramp(0, 1),
                    {png ? io::Depth::uint16 : io::Depth::float32, true, {}});
    const Result result =
        lutconv({"apply", look, folder.path(route.in), "-o", folder.path(route.out)});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const io::FloatImage before = io::read_image(folder.path(route.in)),
                         after = io::read_image(folder.path(route.out));
    const lutlib::Lut lut = io::read_lut(look).lut;
    EXPECT_EQ(after.depth, route.depth);
    for (std::size_t i = 0; i < before.rgba.size(); i += 4) {
        // An EXR holds colours multiplied by alpha, a PNG straight ones; a look sees the straight.
        const float alpha = before.rgba[i + 3], in = png ? 1 : 1 / alpha,
                    out = route.out == "b.png" ? 1 : alpha;
        const lutlib::Rgb expected =
            evaluate(lut, {in * before.rgba[i], in * before.rgba[i + 1], in * before.rgba[i + 2]});
        for (std::size_t c = 0; c < 3; ++c) {
            const float kept = io::info_of(route.depth).integer
                                   ? std::min(std::max(out * expected[c], 0.0F), 1.0F)
                                   : out * expected[c];
            ASSERT_NEAR(after.rgba[i + c], kept, route.tolerance + 1e-7) << i;
        }
        ASSERT_NEAR(after.rgba[i + 3], before.rgba[i + 3], route.tolerance + 1e-7);
    }
}

TEST(Apply, evaluates_a_recipe_exactly_and_clamps_none_of_its_inputs) {
    const Folder folder;
    const std::string recipe = folder.write(
        "r.json", R"({"schema_version": 1, "operators": [{"op": "contrast", "amount": 2}]})");
    io::write_image(folder.path("a.exr"), ramp(-0.5F, 1.5F), {io::Depth::float32, false, {}});
    const Result result = lutconv({"apply", recipe, folder.path("a.exr"), "-o",
                                   folder.path("b.exr"), "--no-convert", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "") << "it was sampled";
    EXPECT_EQ(json::parse(result.out)["pixels_outside_domain"], 0);
    const io::FloatImage before = io::read_image(folder.path("a.exr")),
                         after = io::read_image(folder.path("b.exr"));
    const auto exact = io::Look::open(recipe).exact();
    for (std::size_t i = 0; i < before.rgba.size(); i += 4) {
        const lutlib::RgbD expected =
            exact(lutlib::to_double({before.rgba[i], before.rgba[i + 1], before.rgba[i + 2]}));
        for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_EQ(after.rgba[i + c], static_cast<float>(expected[c])) << i;
        }
    }
}

TEST(Apply, counts_pixels_outside_the_domain_and_clamped_ones) {
    const Folder folder;
    const std::string look = folder.write("double.cube", "LUT_1D_SIZE 2\n0 0 0\n2 2 2\n");
    io::write_image(folder.path("a.exr"), ramp(-1, 2), {io::Depth::float32, false, {}});
    const Result result =
        lutconv({"apply", look, folder.path("a.exr"), "-o", folder.path("b.png"), "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json figures = json::parse(result.out);
    EXPECT_EQ(figures["depth"], "uint16");
    EXPECT_GT(figures["pixels_outside_domain"], 128);
    EXPECT_GT(figures["pixels_clamped"], 100);
    EXPECT_LE(figures["pixels_clamped"], 256);
}

TEST(Apply, writes_a_depth_that_the_file_type_holds_and_says_the_truth_of_it) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(5));
    const std::string floats = folder.path("a.exr"), codes = folder.path("a.png");
    io::write_image(floats, ramp(0, 1), {io::Depth::half, false, {}});
    io::write_image(codes, ramp(0, 1), {io::Depth::uint8, false, {}});
    const auto depth_said = [&](const std::string& in, const std::string& out,
                                const std::string& depth) {
        std::vector<std::string> words{"apply", look, in, "-o", folder.path(out), "--json"};
        if (!depth.empty()) {
            words.insert(words.end(), {"--depth", depth});
        }
        const Result result = lutconv_in_process(words);
        if (result.exit_code != 0) {
            EXPECT_FALSE(std::filesystem::exists(folder.path(out)));
            return std::to_string(result.exit_code) + result.err.substr(result.err.rfind(';'));
        }
        const std::string said = json::parse(result.out)["depth"];
        EXPECT_EQ(io::info_of(io::read_image(folder.path(out)).depth).name, said);
        std::filesystem::remove(folder.path(out));
        return said;
    };
    EXPECT_EQ(depth_said(floats, "x.jpg", ""), "uint8");
    EXPECT_EQ(depth_said(floats, "x.png", ""), "uint16");
    EXPECT_EQ(depth_said(floats, "x.tif", ""), "float");
    EXPECT_EQ(depth_said(codes, "x.hdr", ""), "float");
    EXPECT_EQ(depth_said(codes, "x.exr", ""), "half");
    EXPECT_EQ(depth_said(floats, "x.png", "uint8"), "uint8");
    EXPECT_EQ(depth_said(floats, "x.png", "half"), "3; they store uint8, uint16\n");
    EXPECT_EQ(depth_said(codes, "x.exr", "uint8"), "3; they store half, float\n");
    EXPECT_EQ(depth_said(codes, "x.jpg", "float"), "3; they store uint8\n");
    EXPECT_EQ(depth_said(codes, "x.xyz", "").substr(0, 1), "3");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.cube", "a.exr", "a.png"}));
}

TEST(Apply, leaves_the_old_picture_when_the_input_is_bad) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(5));
    const std::string old = folder.write("old.exr", "old");
    const std::string bad = folder.write("bad.exr", "bad");
    const Result result = lutconv({"apply", look, bad, "-o", old, "--force"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("bad.exr"), std::string::npos) << result.err;
    EXPECT_EQ(contents(old), "old");
    EXPECT_EQ(folder.names().size(), 3U);
}

} // namespace
} // namespace converter_test
