// Which texels a comparison gives to side A.
#include "preview/finish/wipe.h"

#include <gtest/gtest.h>

#include <cmath>

namespace preview {
namespace {

constexpr Size size{200, 100};

double share_of_a(const Wipe& wipe, const Compare& compare) {
    const WipeShape shape = wipe_shape(wipe, compare, size);
    int count = 0;
    for (std::uint32_t y = 0; y < size.height; ++y) {
        for (std::uint32_t x = 0; x < size.width; ++x) {
            count += shows_a(shape, compare, x + 0.5, y + 0.5) ? 1 : 0;
        }
    }
    return count / 20000.0;
}

TEST(Wipe, goes_from_none_to_all_in_every_direction) {
    for (const float angle : {0.0F, 30.0F, 90.0F, 135.0F, 180.0F, 270.0F, 301.5F}) {
        EXPECT_EQ(share_of_a({.split = 0, .split_angle = angle}, compare_split), 0) << angle;
        EXPECT_EQ(share_of_a({.split = 1, .split_angle = angle}, compare_split), 1) << angle;
        EXPECT_NEAR(share_of_a({.split = 0.5F, .split_angle = angle}, compare_split), 0.5, 0.005)
            << angle;
    }
}

TEST(Wipe, has_a_on_the_side_that_its_angle_says) {
    const auto a_at = [](float angle, double x, double y) {
        return shows_a(wipe_shape({.split_angle = angle}, compare_split, size), compare_split, x,
                       y);
    };
    EXPECT_TRUE(a_at(0, 10, 50));
    EXPECT_FALSE(a_at(0, 190, 50));
    EXPECT_TRUE(a_at(90, 100, 10));
    EXPECT_FALSE(a_at(90, 100, 90));
    EXPECT_TRUE(a_at(180, 190, 50));
    EXPECT_TRUE(a_at(270, 100, 90));
    EXPECT_TRUE(a_at(45, 10, 10));
    EXPECT_FALSE(a_at(45, 190, 90));
    // Upright it is exact, as it was before it could be turned.
    EXPECT_EQ(wipe_shape({.split = 0.25F}, compare_split, size), (WipeShape{1, 0, 50, 0}));
}

TEST(Wipe, is_where_the_mouse_takes_it) {
    for (const float angle : {0.0F, 33.0F, 90.0F, 200.0F, 270.0F}) {
        const float split = split_at(angle, 60, 70, size);
        const WipeShape shape =
            wipe_shape({.split = split, .split_angle = angle}, compare_split, size);
        EXPECT_NEAR(60 * shape[0] + 70 * shape[1], shape[2], 1e-3) << angle;
    }
    EXPECT_EQ(split_at(0, -50, 0, size), 0);
    EXPECT_EQ(split_at(0, 500, 0, size), 1);
}

TEST(Wipe, of_a_box_is_its_inside) {
    EXPECT_NEAR(share_of_a({}, compare_box), 0.4 * 0.4, 1e-9);
    EXPECT_EQ(share_of_a({.box_x = 0, .box_y = 0, .box_width = 1, .box_height = 1}, compare_box),
              1);
    EXPECT_EQ(share_of_a({.box_width = 0}, compare_box), 0);
}

TEST(Wipe, moves_and_grows_with_the_picture) {
    for (const Compare* const compare : {&compare_split, &compare_box}) {
        const Wipe wipe{.split = 0.3F, .split_angle = 50};
        const WipeShape shape = wipe_shape(wipe, *compare, size);
        const WipeShape seen = placed(shape, *compare, -30, 20, 4);
        for (const double x : {10.0, 55.0, 61.0, 120.0}) {
            for (const double y : {5.0, 31.0, 80.0}) {
                EXPECT_EQ(shows_a(shape, *compare, x, y),
                          shows_a(seen, *compare, 4 * x - 30, 4 * y + 20));
            }
        }
    }
}

} // namespace
} // namespace preview
