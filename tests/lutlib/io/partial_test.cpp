#include "lutlib/error.h"
#include "lutlib/io/extension.h"
#include "lutlib/io/file.h"
#include "lutlib/io/image.h"
#include "tests/lutlib/io/scratch.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <random>

namespace lutlib::io {
namespace {

constexpr int side = 256;

// Codes that no compression makes small, so that a share of the file is about one of the picture.
FloatImage noise() {
    FloatImage out;
    out.width = out.height = side;
    std::mt19937 random(7);
    for (std::size_t i = 0; i < out.pixels(); ++i) {
        for (int c = 0; c < 3; ++c) {
            out.rgba.push_back(static_cast<float>(random() % 256) / 255);
        }
        out.rgba.push_back(1);
    }
    return out;
}

class PartialPicture : public ::testing::TestWithParam<const char*> {};

TEST_P(PartialPicture, gives_the_rows_that_are_there_and_counts_the_others) {
    if (support::is_sanitized && GetParam() != std::string("x.png")) {
        GTEST_SKIP() << "OpenImageIO takes megabytes for each row, which a sanitizer fills";
    }
    const ScratchFolder folder;
    const std::string path = folder.file(GetParam());
    write_image(path, noise(), {depths_of(path).front(), false, {}});
    const std::string bytes = read_file(path);
    const FloatImage whole = read_image(path, {.partial = true});
    EXPECT_EQ(whole.missing_pixels, 0U);
    EXPECT_EQ(whole.rgba, read_image(path).rgba);
    for (const double share : {0.2, 0.7}) {
        write_file(path, bytes.substr(0, static_cast<std::size_t>(share * double(bytes.size()))));
        EXPECT_THROW(read_image(path), Error) << share;
        const FloatImage part = read_image(path, {.partial = true});
        ASSERT_EQ(part.rgba.size(), whole.rgba.size());
        const auto there = part.pixels() - part.missing_pixels;
        EXPECT_NEAR(double(there) / double(part.pixels()), share, 0.13);
        // Rows are there or black, but for the blocks of a JPEG at the cut.
        std::size_t other = 0;
        for (std::size_t at = 0; at < part.rgba.size(); at += 4 * side) {
            const auto row = part.rgba.begin() + std::ptrdiff_t(at);
            const bool is_black =
                std::all_of(row, row + 4 * side, [](float v) { return v == 0 || v == 1; });
            const bool is_there =
                std::equal(row, row + 4 * side, whole.rgba.begin() + std::ptrdiff_t(at));
            other += is_there || is_black ? 0 : 1;
        }
        EXPECT_LE(other, extension_of(path) == "jpg" ? 16U : 0U) << share;
    }
}

INSTANTIATE_TEST_SUITE_P(Types, PartialPicture,
                         ::testing::Values("x.png", "x.exr", "x.tif", "x.jpg", "x.dpx", "x.bmp",
                                           "x.ppm"),
                         [](const auto& tested) { return std::string(tested.param + 2); });

TEST(Picture, whose_strips_do_not_unpack_is_refused) {
    if (support::is_sanitized) {
        GTEST_SKIP() << "OpenImageIO takes megabytes for each row, which a sanitizer fills";
    }
    const ScratchFolder folder;
    const std::string path = folder.file("x.tif");
    FloatImage grey = noise();
    std::fill(grey.rgba.begin(), grey.rgba.begin() + 4 * side * side / 2, 0.5F); // so that zip pays
    write_image(path, grey, {Depth::uint8, false, {}});
    std::string bytes = read_file(path);
    EXPECT_EQ(read_image(path).missing_pixels, 0U);
    bytes.replace(bytes.size() / 2, 200, 200, '\0');
    write_file(path, bytes);
    EXPECT_THROW(read_image(path), Error);
    const std::size_t missing = read_image(path, {.partial = true}).missing_pixels;
    EXPECT_GT(missing, 0U);
    EXPECT_LT(missing, grey.pixels());
}

TEST(Picture, of_which_nothing_is_there_is_refused_in_part_too) {
    const ScratchFolder folder;
    for (const std::string name : {"x.png", "x.exr", "x.tga"}) {
        const std::string path = folder.file(name);
        write_image(path, noise(), {depths_of(path).front(), false, {}});
        write_file(path, read_file(path).substr(0, name == "x.exr" ? 400 : 60));
        EXPECT_THROW(read_image(path, {.partial = true}), Error) << name;
    }
}

} // namespace
} // namespace lutlib::io
