// What a picture's file holds besides its colours, through reading and writing.
#include "lutlib/error.h"
#include "lutlib/io/alpha.h"
#include "lutlib/io/file.h"
#include "lutlib/io/image.h"
#include "lutlib/io/orientation.h"
#include "lutlib/io/png.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lutlib::io {
namespace {

// Each pixel tells where it is.
FloatImage numbered(int width, int height) {
    FloatImage out;
    out.width = width;
    out.height = height;
    for (int i = 0; i < width * height; ++i) {
        out.rgba.insert(out.rgba.end(), {static_cast<float>(i), 0, 0, 1});
    }
    return out;
}

std::vector<int> reds(const FloatImage& image) {
    std::vector<int> out;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        out.push_back(static_cast<int>(image.rgba[i]));
    }
    return out;
}

TEST(Orientation, of_each_number_comes_upright) {
    // 0 1 2
    // 3 4 5
    const FloatImage stored = numbered(3, 2);
    const std::vector<std::vector<int>> wanted{
        {0, 1, 2, 3, 4, 5}, {2, 1, 0, 5, 4, 3}, {5, 4, 3, 2, 1, 0}, {3, 4, 5, 0, 1, 2},
        {0, 3, 1, 4, 2, 5}, {3, 0, 4, 1, 5, 2}, {5, 2, 4, 1, 3, 0}, {2, 5, 1, 4, 0, 3}};
    for (int i = 1; i <= 8; ++i) {
        const FloatImage out = upright(stored, i);
        EXPECT_EQ(reds(out), wanted[static_cast<std::size_t>(i) - 1]) << i;
        EXPECT_EQ(out.width, i < 5 ? 3 : 2) << i;
    }
}

TEST(Alpha, is_divided_out_and_multiplied_back_and_light_without_alpha_is_kept) {
    FloatImage image = numbered(3, 1);
    image.rgba = {0.2F, 0.1F, 0, 0.5F, 0.3F, 0.3F, 0.3F, 0, 1, 2, 3, 1};
    image.alpha = image.premultiplied = true;
    const std::vector<float> stored = image.rgba;
    const LightOnly light = make_straight(image);
    EXPECT_FLOAT_EQ(image.rgba[0], 0.4F);
    EXPECT_EQ(light.size(), 1U);
    EXPECT_TRUE(make_straight(image).empty()) << "straight already";
    std::fill_n(image.rgba.begin() + 4, 3, 9.0F); // a look on what has no straight form
    premultiply(image, light);
    for (std::size_t i = 0; i < stored.size(); ++i) {
        EXPECT_FLOAT_EQ(image.rgba[i], stored[i]) << i;
    }
}

TEST(KeptChunks, go_from_png_to_png_as_they_are_and_those_of_color_only_where_they_stay_true) {
    const ScratchFolder folder;
    PngImage png;
    png.width = png.height = 2;
    png.samples.assign(12, 7);
    png.text = {{"Author", "somebody"}};
    png.icc_profile = std::string(200, 'p');
    // libspng takes profiles as they are.
    const std::string bytes = write_png(png);
    const FloatImage image = decode_image(bytes, "png", "a.png");
    ASSERT_TRUE(image.source);
    for (const bool stays : {true, false}) {
        const std::string path = folder.file("b.png");
        const auto lost = write_image(path, image,
                                      {.depth = Depth::uint8,
                                       .alpha = false,
                                       .text = {},
                                       .keep = image.source.get(),
                                       .keep_color = stays});
        const PngImage back = read_png(read_file(path), path);
        EXPECT_EQ(back.text, png.text);
        EXPECT_EQ(back.icc_profile, stays ? png.icc_profile : "");
        EXPECT_EQ(lost.size(), stays ? 0U : 1U);
        EXPECT_EQ(back.samples, png.samples);
    }
}

TEST(Image, that_is_an_iff_is_refused_under_any_name) {
    const ScratchFolder folder;
    const std::string path = folder.file("x.png");
    write_file(path, std::string("FOR4\0\0\0\x58", 8) + "CIMG");
    EXPECT_THROW(read_image(path), Error);
}

TEST(Image, that_declares_more_than_its_file_can_hold_is_cut_short) {
    const ScratchFolder folder;
    const std::string path = folder.file("bomb.tga");
    write_file(path, std::string("\0\0\2\0\0\0\0\0\0\0\0\0\0\x10\0\x10\x20\x08", 18));
    try {
        read_image(path);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("cut short"), std::string::npos);
    }
}

} // namespace
} // namespace lutlib::io
