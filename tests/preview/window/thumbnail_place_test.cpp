// Where a small picture goes in a window, and what of it.
#include "preview/window/thumbnail_place.h"

#include <gtest/gtest.h>

namespace preview {
namespace {

constexpr Size small_picture{100, 50}, whole_window{800, 600};
constexpr FramebufferScale same_scale;

panels::PlacedThumbnail at(float x, float y) {
    return {x, y, 100, 50, 0, 0, 800, 600, 0};
}

TEST(ThumbnailPlace, is_pixel_for_pixel_where_all_of_it_is_seen) {
    const ThumbnailPlace place = place_in(at(30, 40), same_scale, small_picture, whole_window);
    EXPECT_EQ(place.from, (PixelBox{0, 0, 100, 50}));
    EXPECT_EQ(place.to, (PixelBox{30, 40, 130, 90}));
}

TEST(ThumbnailPlace, shows_the_part_that_is_within_its_clip_where_it_was) {
    panels::PlacedThumbnail placed = at(30, 40);
    placed.clip_left = 50;
    placed.clip_bottom = 60;
    const ThumbnailPlace place = place_in(placed, same_scale, small_picture, whole_window);
    EXPECT_EQ(place.from, (PixelBox{20, 0, 100, 20}));
    EXPECT_EQ(place.to, (PixelBox{50, 40, 130, 60}));
}

TEST(ThumbnailPlace, never_leaves_the_window) {
    const ThumbnailPlace low = place_in(at(-90, -20), same_scale, small_picture, whole_window);
    EXPECT_EQ(low.from, (PixelBox{90, 20, 100, 50}));
    EXPECT_EQ(low.to, (PixelBox{0, 0, 10, 30}));
    panels::PlacedThumbnail placed = at(750, 580);
    placed.clip_right = placed.clip_bottom = 1e4F;
    const ThumbnailPlace high = place_in(placed, same_scale, small_picture, whole_window);
    EXPECT_EQ(high.to, (PixelBox{750, 580, 800, 600}));
    EXPECT_EQ(high.from, (PixelBox{0, 0, 50, 20}));
}

TEST(ThumbnailPlace, is_empty_outside_of_its_clip_and_the_window) {
    EXPECT_TRUE(place_in(at(900, 0), same_scale, small_picture, whole_window).is_empty());
    EXPECT_TRUE(place_in(at(-100, 0), same_scale, small_picture, whole_window).is_empty());
    panels::PlacedThumbnail placed = at(30, 40);
    placed.clip_right = 30;
    EXPECT_TRUE(place_in(placed, same_scale, small_picture, whole_window).is_empty());
}

TEST(ThumbnailPlace, is_scaled_where_it_is_shown_smaller_and_where_coordinates_are_not_pixels) {
    panels::PlacedThumbnail placed = at(30, 40);
    placed.width = 50;
    placed.height = 25;
    placed.clip_left = 40;
    const ThumbnailPlace half = place_in(placed, same_scale, small_picture, whole_window);
    EXPECT_EQ(half.from, (PixelBox{20, 0, 100, 50}));
    EXPECT_EQ(half.to, (PixelBox{40, 40, 80, 65}));
    const ThumbnailPlace fine = place_in(placed, {2, 2}, small_picture, {1600, 1200});
    EXPECT_EQ(fine.from, (PixelBox{20, 0, 100, 50}));
    EXPECT_EQ(fine.to, (PixelBox{80, 80, 160, 130}));
}

} // namespace
} // namespace preview
