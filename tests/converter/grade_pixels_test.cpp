#include "tests/converter/run_program.h"

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/image.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace converter_test {
namespace {

namespace io = lutlib::io;
using nlohmann::json;

// Every channel over all of 0..1, in an order of its own.
io::FloatImage colors(bool alpha) {
    io::FloatImage out;
    out.width = 64;
    out.height = 33;
    out.alpha = alpha;
    for (int i = 0; i < out.width * out.height; ++i) {
        for (const int step : {7, 11, 13}) {
            out.rgba.push_back(static_cast<float>(i * step % 256) / 255);
        }
        out.rgba.push_back(alpha ? static_cast<float>(i % 256) / 255 : 1.0F);
    }
    return out;
}

std::string picture(const Folder& folder, const std::string& name, io::Depth depth, bool alpha) {
    io::write_image(folder.path(name), colors(alpha), {.depth = depth, .alpha = alpha, .text = {}});
    return folder.path(name);
}

// A pixel's colour and alpha after the look, exactly.
std::array<double, 4> graded(const lutlib::Lut& look, const io::FloatImage& image, std::size_t i) {
    const float* const c = &image.rgba[4 * i];
    const lutlib::RgbD out = evaluate_exact(look, lutlib::to_double({c[0], c[1], c[2]}));
    return {out.r, out.g, out.b, static_cast<double>(c[3])};
}

TEST(ApplyPixels, grades_codes_as_the_look_says_and_makes_no_floats_of_them) {
    for (const io::Depth depth : {io::Depth::uint8, io::Depth::uint16}) {
        for (const bool alpha : {false, true}) {
            const Folder folder;
            const std::string look = folder.write("look.cube", saturated_cube(17));
            const std::string in = picture(folder, "in.png", depth, alpha);
            const Result result = lutconv(
                {"apply", look, in, "-o", folder.path("out.png"), "--no-convert", "--json"});
            ASSERT_EQ(result.exit_code, 0) << result.err;
            const lutlib::Lut lut = io::read_lut(look).lut;
            const io::FloatImage before = io::read_image(in),
                                 after = io::read_image(folder.path("out.png"));
            ASSERT_EQ(after.rgba.size(), before.rgba.size());
            const double step = depth == io::Depth::uint8 ? 1.0 / 255 : 1.0 / 65535;
            for (std::size_t i = 0; i < before.rgba.size() / 4; ++i) {
                const auto wanted = graded(lut, before, i);
                for (std::size_t c = 0; c < 4; ++c) {
                    // Rounded to the nearest code, and hundredths of a code.
                    ASSERT_NEAR(after.rgba[4 * i + c], std::min(std::max(wanted[c], 0.0), 1.0),
                                0.52 * step)
                        << i << ' ' << c;
                }
            }
        }
    }
}

TEST(ApplyPixels, counts_what_it_clamps_of_codes_too) {
    const Folder folder;
    // Twice the picture's values: half of the codes leave 0..1.
    const std::string look = folder.write("twice.cube", "LUT_1D_SIZE 2\n0 0 0\n2 2 2\n");
    const std::string in = picture(folder, "in.png", io::Depth::uint8, false);
    const Result result =
        lutconv({"apply", look, in, "-o", folder.path("out.png"), "--no-convert", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const io::FloatImage before = io::read_image(in);
    std::size_t clamped = 0;
    for (std::size_t i = 0; i < before.rgba.size(); i += 4) {
        clamped += before.rgba[i] > 0.5F || before.rgba[i + 1] > 0.5F || before.rgba[i + 2] > 0.5F;
    }
    EXPECT_EQ(json::parse(result.out)["pixels_clamped"], clamped);
    EXPECT_TRUE(json::parse(result.out)["left_out"].empty());
}

TEST(ApplyPixels, says_what_a_picture_does_not_need_and_leaves_it_out) {
    const Folder folder;
    ASSERT_EQ(lutconv({"edit", "identity", "-o", folder.path("identity.cube")}).exit_code, 0);
    const std::string in = picture(folder, "in.png", io::Depth::uint16, true);
    const Result result = lutconv({"apply", folder.path("identity.cube"), in, "-o",
                                   folder.path("out.png"), "--no-convert", "--explain"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("left out: the look is the identity over its domain"),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("left out: floats"), std::string::npos) << result.out;
    EXPECT_EQ(io::read_image(folder.path("out.png")).rgba, io::read_image(in).rgba);

    // Colours outside its domain are clamped to it, so there it has a part.
    io::FloatImage light = colors(false);
    light.rgba[0] = 1.5F;
    io::write_image(folder.path("in.exr"), light,
                    {.depth = io::Depth::float32, .alpha = false, .text = {}});
    const Result clamped = lutconv({"apply", folder.path("identity.cube"), folder.path("in.exr"),
                                    "-o", folder.path("out.exr"), "--no-convert", "--explain"});
    ASSERT_EQ(clamped.exit_code, 0) << clamped.err;
    EXPECT_NE(clamped.out.find("everything is needed"), std::string::npos) << clamped.out;
    EXPECT_EQ(io::read_image(folder.path("out.exr")).rgba[0], 1);
}

TEST(ApplyPixels, mixes_the_pictures_own_codes_with_the_graded_ones_by_strength) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(17));
    const lutlib::Lut lut = io::read_lut(look).lut;
    for (const char* type : {"png", "exr"}) {
        const std::string in =
            picture(folder, std::string("in.") + type,
                    type == std::string("png") ? io::Depth::uint16 : io::Depth::float32, false);
        const io::FloatImage before = io::read_image(in);
        for (const double strength : {0.0, 0.6, 1.0}) {
            const std::string out = folder.path(std::string("out.") + type);
            const Result result = lutconv({"apply", look, in, "-o", out, "--no-convert",
                                           "--strength", std::to_string(strength)});
            ASSERT_EQ(result.exit_code, 0) << result.err;
            const io::FloatImage after = io::read_image(out);
            for (std::size_t i = 0; i < before.rgba.size() / 4; ++i) {
                const auto wanted = graded(lut, before, i);
                for (std::size_t c = 0; c < 3; ++c) {
                    const double own = static_cast<double>(before.rgba[4 * i + c]);
                    const double mixed = own + strength * (wanted[c] - own);
                    const bool held = type == std::string("png");
                    ASSERT_NEAR(after.rgba[4 * i + c],
                                held ? std::min(std::max(mixed, 0.0), 1.0) : mixed,
                                held ? 0.52 / 65535 : 4e-7);
                }
            }
        }
    }
}

TEST(ApplyPixels, mixes_only_codes_of_one_encoding) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(9));
    const std::string in = picture(folder, "in.exr", io::Depth::half, false);
    const std::vector<std::string> command{"apply",
                                           look,
                                           in,
                                           "-o",
                                           folder.path("out.exr"),
                                           "--look-input",
                                           "srgb",
                                           "--look-output",
                                           "gamma24",
                                           "--strength",
                                           "0.6"};
    const Result refused = lutconv(command);
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_NE(refused.err.find("add --output-encoding linear"), std::string::npos) << refused.err;
    std::vector<std::string> remedied = command;
    remedied.insert(remedied.end(), {"--output-encoding", "linear"});
    EXPECT_EQ(lutconv(remedied).exit_code, 0);
    // A picture that does not say what it holds is taken for what the look takes.
    const std::string png = folder.path("in.png");
    lutlib::io::write_image(png, lutlib::io::read_image(in),
                            {lutlib::io::Depth::uint16, false, {}});
    std::vector<std::string> assumed = command;
    assumed[2] = png;
    const Result mixed = lutconv(assumed);
    EXPECT_EQ(mixed.exit_code, 3);
    EXPECT_NE(mixed.err.find("srgb (as the look takes them): add --output-encoding srgb"),
              std::string::npos)
        << mixed.err;
    EXPECT_EQ(
        lutconv({"apply", look, in, "-o", folder.path("out.exr"), "--strength", "2"}).exit_code, 3);
}

} // namespace
} // namespace converter_test
