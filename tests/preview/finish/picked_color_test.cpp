// The figures of a colour that was kept.
#include "preview/finish/picked_color.h"

#include <gtest/gtest.h>

namespace preview {
namespace {

TEST(PickedColor, has_the_figures_of_what_a_display_shows) {
    const ColorFigures white = figures_of({1, 1, 1}, 100);
    EXPECT_NEAR(white.luminance, 100, 1e-9);
    EXPECT_NEAR(white.lab.L, 100, 1e-6);
    EXPECT_NEAR(white.lab.a, 0, 1e-6);
    // Grey of 18 % is L* 49.5 (CIE 15:2004).
    const double code = 117.7 / 255;
    const ColorFigures grey = figures_of({code, code, code}, 203);
    EXPECT_NEAR(grey.linear.g, 0.18, 1e-3);
    EXPECT_NEAR(grey.luminance, 203 * 0.18, 0.2);
    EXPECT_NEAR(grey.lab.L, 49.5, 0.1);
    EXPECT_EQ(codes_text(grey), "118 118 118");
    // What no display shows is held to what it does.
    const ColorFigures beyond = figures_of({2, -1, 0.5}, 100);
    EXPECT_EQ(codes_text(beyond), "255 0 128");
    EXPECT_EQ(beyond.linear.r, 1);
}

TEST(PickedColor, goes_before_the_others_and_the_oldest_go) {
    std::vector<PickedColor> picked;
    for (int i = 0; i < 20; ++i) {
        pick(picked, {.place = {i, 0}});
    }
    EXPECT_EQ(picked.size(), most_picked_colors);
    EXPECT_EQ(picked.front().place.x, 19);
    EXPECT_EQ(picked.back().place.x, 4);
}

} // namespace
} // namespace preview
