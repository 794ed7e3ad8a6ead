// Rendered pictures in files: what numbers they hold, at which depth, with which alpha.
#include "lutlib/color/encoding.h"
#include "lutlib/error.h"
#include "preview/cli/look_options.h"
#include "preview/cli/picture_file.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

namespace preview {
namespace {

using lutlib::io::Depth;

/// One texel that 8 bits do not hold, and one of them white.
Rendered two_texels() {
    Rendered out;
    out.size = {2, 1};
    out.values = {0.5F, 0.1234F, 0.25F, 1, 1, 1, 1, 1};
    return out;
}

TEST(PictureFile, of_16_bits_holds_codes_of_16_bits) {
    const lutlib::ScratchFolder folder;
    const std::string path = folder.file("x.png");
    write_picture(path, two_texels(), file_format(path, "uint16"));
    const lutlib::io::FloatImage back = lutlib::io::read_image(path);
    EXPECT_EQ(back.depth, Depth::uint16);
    EXPECT_TRUE(back.srgb_tag);
    EXPECT_FALSE(back.alpha);
    EXPECT_NEAR(back.rgba[1], 0.1234F, 0.5F / 65535 + 1e-7F);
}

TEST(PictureFile, that_holds_light_gets_light_and_numbers_as_they_are) {
    const lutlib::ScratchFolder folder;
    const std::string path = folder.file("x.exr");
    const FileFormat format = file_format(path, "float");
    write_picture(path, two_texels(), format);
    const double light = lutlib::srgb().decode(0.5);
    EXPECT_NEAR(static_cast<double>(lutlib::io::read_image(path).rgba[0]), light, 1e-6);
    write_picture(path, two_texels(), format, Content::numbers);
    EXPECT_EQ(lutlib::io::read_image(path).rgba[0], 0.5F);
}

TEST(PictureFile, is_refused_a_depth_that_its_type_has_not) {
    const lutlib::ScratchFolder folder;
    EXPECT_THROW(file_format(folder.file("x.png"), "half"), lutlib::UsageError);
    EXPECT_THROW(file_format(folder.file("x.png"), "uint9"), lutlib::UsageError);
    for (const char* const name : {"x.nonsense", "x"}) {
        EXPECT_THROW(file_format(folder.file(name), ""), lutlib::UsageError) << name;
    }
    EXPECT_EQ(file_format(folder.file("x.exr"), "").frame_format(), Format::rgba32f);
    EXPECT_EQ(file_format(folder.file("x.png"), "").frame_format(), Format::rgba8);
}

TEST(PictureFile, of_the_surroundings_is_named_in_what_is_said_of_it) {
    const lutlib::ScratchFolder folder;
    Options options;
    options.surroundings = folder.file("room.png");
    write_picture(options.surroundings, two_texels(), file_format(options.surroundings, ""));
    const Shown shown = shown_of(options);
    ASSERT_EQ(shown.told.size(), 1U);
    EXPECT_EQ(shown.told[0],
              options.surroundings + ": it holds no light: its codes are decoded as sRGB");
    EXPECT_TRUE(shown.not_written.empty());
}

TEST(PictureFile, of_a_picture_or_surroundings_says_which_numbers_are_no_light) {
    const lutlib::ScratchFolder folder;
    const std::string path = folder.file("odd.exr");
    lutlib::io::FloatImage image;
    image.width = 4;
    image.height = 1;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float inf = std::numeric_limits<float>::infinity();
    image.rgba = {nan, 1, 1, 1, 1, nan, 1, 1, inf, 1, 1, 1, 1, 1, -1, 1};
    lutlib::io::ImageWriteOptions options;
    options.depth = lutlib::io::Depth::float32;
    static_cast<void>(lutlib::io::write_image(path, image, options));
    const std::vector<std::string> told{
        path + ": 2 pixels hold NaN, which is taken for 0",
        path + ": 1 pixel holds infinity, which is taken for 65504, the largest half float",
        path + ": 1 pixel holds numbers below 0; what is still below 0 as it is shown is 0 there"};
    EXPECT_EQ(load_shown(path, 0).told, told);
    Shown scene = load_shown("plain", 0);
    EXPECT_TRUE(told_of_surroundings(scene).empty());
    load_surroundings(scene, path);
    EXPECT_EQ(scene.told, told);
    EXPECT_EQ(told_of_surroundings(scene), told);
    EXPECT_EQ(scene.surroundings->rgba[0], 0);
    EXPECT_EQ(scene.surroundings->rgba[8], 65504);
}

TEST(PictureFile, keeps_the_alpha_of_the_picture) {
    ShownPicture picture;
    picture.size = {4, 2};
    picture.has_alpha = true;
    for (const float alpha : {0.0F, 0.5F, 1.0F, 1.0F, 0.25F, 0.25F, 0.0F, 1.0F}) {
        picture.rgba.insert(picture.rgba.end(), {0, 0, 0, alpha});
    }
    EXPECT_EQ(alpha_for(picture, {4, 2}), (std::vector<float>{0, 0.5F, 1, 1, 0.25F, 0.25F, 0, 1}));
    EXPECT_EQ(alpha_for(picture, {2, 1}), (std::vector<float>{0.25F, 0.75F}));
    EXPECT_EQ(alpha_for(picture, {4, 1}), (std::vector<float>{0.25F, 0.75F, 0.25F, 0.75F}));

    const lutlib::ScratchFolder folder;
    const std::string path = folder.file("x.png");
    write_picture(path, two_texels(), file_format(path, ""), Content::codes, {0.2F, 1});
    const lutlib::io::FloatImage back = lutlib::io::read_image(path);
    EXPECT_TRUE(back.alpha);
    EXPECT_NEAR(back.rgba[3], 0.2F, 1e-6F);
    picture.has_alpha = false;
    EXPECT_TRUE(alpha_for(picture, {4, 2}).empty());
}

TEST(PictureFile, of_light_keeps_alpha_as_its_type_stores_it) {
    const lutlib::ScratchFolder folder;
    const std::string path = folder.file("x.exr");
    Rendered rendered = two_texels();
    rendered.hdr = {3, 2, 1, 1, 0.5F, 0.5F, 0.5F, 1};
    rendered.hdr_size = rendered.size;
    write_light(path, rendered, file_format(path, "float"), {0.5F, 1});
    const lutlib::io::FloatImage back = lutlib::io::read_image(path);
    EXPECT_TRUE(back.alpha);
    EXPECT_EQ(back.rgba, (std::vector<float>{1.5F, 1, 0.5F, 0.5F, 0.5F, 0.5F, 0.5F, 1}));
    write_light(path, rendered, file_format(path, "float"));
    EXPECT_FALSE(lutlib::io::read_image(path).alpha);

    const std::string without = folder.file("x.hdr");
    EXPECT_EQ(write_light(without, rendered, file_format(without, ""), {0.5F, 1}),
              std::vector<std::string>{"the alpha"});
    const lutlib::io::FloatImage straight = lutlib::io::read_image(without);
    EXPECT_FALSE(straight.alpha);
    EXPECT_NEAR(straight.rgba[0], 3, 0.02);
    EXPECT_NEAR(straight.rgba[4], 0.5, 0.005);
}

TEST(PictureFile, of_premultiplied_colours_is_shown_straight_and_written_as_its_type_stores_them) {
    const lutlib::ScratchFolder folder;
    const std::string path = folder.file("x.exr");
    write_picture(path, two_texels(), file_format(path, "float"), Content::numbers, {0.5F, 1});
    EXPECT_EQ(lutlib::io::read_image(path).rgba[0], 0.25F);

    const Shown shown = load_shown(path, 0);
    ASSERT_TRUE(shown.picture);
    EXPECT_EQ(shown.picture->rgba[0], 0.5F);
    EXPECT_EQ(shown.picture->rgba[3], 0.5F);
    ASSERT_EQ(shown.told.size(), 1U);
    EXPECT_NE(shown.told[0].find("multiplied by its alpha"), std::string::npos);

    write_picture(path, two_texels(), file_format(path, "float"), Content::numbers, {1, 1});
    EXPECT_TRUE(load_shown(path, 0).told.empty());
}

} // namespace
} // namespace preview
