// Channels by name, never by place.
#include "lutlib/io/picture_channels.h"

#include "lutlib/error.h"

#include <gtest/gtest.h>

namespace lutlib::io {
namespace {

using At = std::array<int, 4>;

PicturePart exr(std::vector<std::string> channels, std::string name = {}) {
    return {std::move(name), std::move(channels), -1, false};
}

PictureChannels taken(const std::vector<PicturePart>& parts, std::string_view layer = {}) {
    return require_picture(pictures_among(parts, "x.exr"), parts, layer, "x.exr");
}

TEST(PictureChannels, are_found_by_name_in_any_order_and_of_any_case) {
    EXPECT_EQ(taken({exr({"A", "B", "G", "R", "Z"})}).at, (At{3, 2, 1, 0}));
    EXPECT_EQ(taken({exr({"red", "Green", "BLUE"})}).at, (At{0, 1, 2, -1}));
    EXPECT_EQ(taken({exr({"R", "G", "B", "Z"})}).at, (At{0, 1, 2, -1})) << "depth is no alpha";
    EXPECT_EQ(taken({exr({".R", ".G", ".B"})}).at, (At{0, 1, 2, -1}));
    EXPECT_EQ(taken({exr({"Z", "Y"})}).at, (At{1, 1, 1, -1}));
}

TEST(PictureChannels, of_a_renderer_are_its_combined_picture_before_its_other_outputs) {
    const std::vector<PicturePart> blender{
        exr({"ViewLayer.AO.B", "ViewLayer.AO.G", "ViewLayer.AO.R", "ViewLayer.Combined.A",
             "ViewLayer.Combined.B", "ViewLayer.Combined.G", "ViewLayer.Combined.R",
             "ViewLayer.Depth.Z"})};
    EXPECT_EQ(taken(blender).at, (At{6, 5, 4, 3}));
    EXPECT_EQ(taken(blender, "viewlayer.ao").at, (At{2, 1, 0, -1}));
    const auto pictures = pictures_among(blender, "x.exr");
    const auto remarks = channel_remarks(pictures[0], pictures, blender);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("'ViewLayer.Combined'"), std::string::npos);
    EXPECT_NE(remarks[0].find("ViewLayer.AO"), std::string::npos);
    EXPECT_EQ(taken({exr({"diffuse.R", "diffuse.G", "diffuse.B", "R", "G", "B"})}).at,
              (At{3, 4, 5, -1}));
}

TEST(PictureChannels, of_several_parts_are_those_of_the_part_that_holds_a_picture) {
    const std::vector<PicturePart> parts{exr({"Z"}, "depth"), exr({"R", "G", "B", "A"}, "rgba"),
                                         exr({"R", "G", "B"}, "left")};
    EXPECT_EQ(taken(parts).part, 1U);
    EXPECT_EQ(taken(parts, "left").part, 2U);
    EXPECT_THROW(taken(parts, "right"), Error);
}

TEST(PictureChannels, that_are_no_picture_are_refused_by_their_names) {
    for (const std::vector<std::string>& names :
         {std::vector<std::string>{"Z", "velocity.X"}, std::vector<std::string>{"Y", "RY", "BY"}}) {
        try {
            taken({exr(names)});
            FAIL() << names[0];
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(names[0]), std::string::npos);
        }
    }
}

TEST(PictureChannels, of_one_color_alone_are_grey_and_that_is_said) {
    const std::vector<PicturePart> parts{exr({"A", "G"})};
    const auto pictures = pictures_among(parts, "x.exr");
    ASSERT_EQ(pictures.size(), 1U);
    EXPECT_EQ(pictures[0].at, (At{1, 1, 1, 0}));
    const auto remarks = channel_remarks(pictures[0], pictures, parts);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("only the channel 'G'"), std::string::npos) << remarks[0];
    EXPECT_TRUE(pictures_among({exr({"R", "G"})}, "x.exr").empty()) << "two are no grey";
    EXPECT_TRUE(channel_remarks(pictures_among({exr({"Y"})}, "x.exr")[0],
                                pictures_among({exr({"Y"})}, "x.exr"), {exr({"Y"})})
                    .empty());
}

TEST(PictureChannels, without_names_stand_in_their_usual_order) {
    PicturePart tiff{{}, {"c0", "c1", "c2", "c3", "c4"}, 3, true};
    EXPECT_EQ(taken({tiff}).at, (At{0, 1, 2, 3}));
    EXPECT_EQ(taken({PicturePart{{}, {"c0", "c1"}, 1, true}}).at, (At{0, 0, 0, 1}));
}

} // namespace
} // namespace lutlib::io
