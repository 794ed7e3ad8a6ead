// Which part of a picture is seen: sizes, places, and what stays where it is.
#include "preview/finish/zoom.h"

#include <gtest/gtest.h>

namespace preview {
namespace {

constexpr Size own{4000, 3000}, output{800, 500};

/// What of the picture, in its pixels, is at a pixel of the output.
OutputPoint shown_at(const Zoom& zoom, OutputPoint at) {
    const ZoomPlace place = zoom_place(zoom, own, own, output);
    return {(at.x - static_cast<float>(place.left)) / place.scale,
            (at.y - static_cast<float>(place.top)) / place.scale};
}

TEST(Zoom, makes_a_picture_no_larger_than_it_is_and_smaller_where_it_is_seen_smaller) {
    EXPECT_EQ(made_size({.scale = 1}, own), own);
    EXPECT_EQ(made_size({.scale = 8}, own), own);
    EXPECT_EQ(made_size({.scale = 0.5F}, own), (Size{2000, 1500}));
    EXPECT_EQ(made_size({.scale = least_zoom}, {3, 3}), (Size{1, 1}));
    // A side that is rounded is seen as it was made.
    const Zoom third{.scale = 1.0F / 3};
    EXPECT_EQ(zoom_place(third, {100, 50}, made_size(third, {100, 50}), output).scale, 1);
}

TEST(Zoom, leaves_no_room_beside_a_larger_picture_and_puts_a_smaller_one_in_the_middle) {
    for (const float x : {0.0F, 0.3F, 1.0F}) {
        const ZoomPlace large = zoom_place({.scale = 1, .x = x, .y = x}, own, own, output);
        EXPECT_LE(large.left, 0);
        EXPECT_LE(large.top, 0);
        EXPECT_GE(large.left + 4000, 800);
        EXPECT_GE(large.top + 3000, 500);
        const ZoomPlace small = zoom_place({.scale = 2, .x = x}, {100, 50}, {100, 50}, output);
        EXPECT_EQ(small.left, 300);
        EXPECT_EQ(small.top, 200);
    }
    EXPECT_EQ(zoom_place({.scale = 1, .x = 0.5F, .y = 0.5F}, own, own, output).left, -1600);
}

TEST(Zoom, keeps_what_is_under_the_mouse_where_it_is) {
    Zoom zoom{.scale = 1, .x = 0.4F, .y = 0.6F};
    const OutputPoint mouse{200, 400};
    const OutputPoint before = shown_at(zoom, mouse);
    for (const float factor : {1.25F, 2.0F, 4.0F, 0.8F, 0.5F}) {
        zoom = zoomed_by(zoom, factor, mouse, own, output);
        const OutputPoint now = shown_at(zoom, mouse);
        // The picture begins at a whole pixel of the output.
        EXPECT_NEAR(now.x, before.x, 0.6 / static_cast<double>(zoom.scale) + 0.5) << zoom.scale;
        EXPECT_NEAR(now.y, before.y, 0.6 / static_cast<double>(zoom.scale) + 0.5) << zoom.scale;
    }
}

TEST(Zoom, begins_at_all_of_the_picture_and_ends_there) {
    const Zoom in = zoomed_by({}, 1.25F, {400, 250}, own, output);
    EXPECT_NEAR(in.scale, 1.25F * 500 / 3000, 1e-4);
    EXPECT_EQ(zoomed_by(in, 0.5F, {0, 0}, own, output), Zoom{});
    // Near a whole number it is that number.
    EXPECT_EQ(zoomed_by({.scale = 0.8F}, 1.25F, {400, 250}, own, output).scale, 1);
    EXPECT_EQ(zoomed_by({.scale = 60}, 2, {0, 0}, own, output).scale, most_zoom);
    EXPECT_EQ(zoomed_by({.scale = 1}, 0.001F, {0, 0}, own, output).scale, 0);
}

TEST(Zoom, is_carried_as_far_as_the_mouse_and_not_beyond_the_picture) {
    const Zoom zoom{.scale = 2, .x = 0.5F, .y = 0.5F};
    const ZoomPlace before = zoom_place(zoom, own, own, output);
    const ZoomPlace moved = zoom_place(panned_by(zoom, {30, -20}, own, output), own, own, output);
    EXPECT_NEAR(moved.left, before.left + 30, 1);
    EXPECT_NEAR(moved.top, before.top - 20, 1);
    const Zoom far = panned_by(zoom, {1e6F, 1e6F}, own, output);
    EXPECT_EQ(zoom_place(far, own, own, output).left, 0);
    // Back again at once, and not after as far a way as it went beyond.
    EXPECT_NEAR(zoom_place(panned_by(far, {-10, 0}, own, output), own, own, output).left, -10, 1);
}

} // namespace
} // namespace preview
