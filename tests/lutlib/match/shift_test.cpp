#include "lutlib/match/shift.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lutlib {
namespace {

// Patches with edges, as a scene has them; `at` is where the camera points.
RgbD scene(double x, double y) {
    const auto cell = [](double v, double size) { return std::floor(v / size); };
    const double patch = std::abs(std::sin(12.9 * cell(x, 23) + 78.2 * cell(y, 17)));
    const double other = std::abs(std::sin(4.1 * cell(x + y, 31) + 3.3));
    const double shade = 0.15 * std::sin(x / 40) * std::cos(y / 50);
    return {0.15 + 0.5 * patch + shade, 0.2 + 0.4 * patch * other + shade,
            0.25 + 0.4 * other + shade};
}

template <class F, class Where>
Picture taken(int width, int height, F look, Where where) {
    Picture out{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto [from_x, from_y] = where(x, y);
            out.pixels.push_back(to_float(look(scene(from_x, from_y))));
        }
    }
    return out;
}

const auto as_it_is = [](RgbD c) { return c; };
const auto in_place = [](double x, double y) { return std::pair(x, y); };

TEST(FindShift, finds_each_shift_under_each_look_and_a_negative) {
    std::vector<TestLook> looks = test_looks();
    looks.push_back({"negative", [](RgbD c) { return RgbD{1 - c.r, 1 - c.g, 1 - c.b}; }});
    const Picture before = taken(240, 160, as_it_is, in_place);
    for (const TestLook& look : looks) {
        for (const Pixel by : {Pixel{0, 0}, Pixel{1, 0}, Pixel{-7, 12}, Pixel{40, -25}}) {
            const Picture after = taken(240, 160, look.f, [by](double x, double y) {
                return std::pair(x - by.x, y - by.y);
            });
            const Shift found = find_shift(before, after);
            EXPECT_EQ(found.by, by) << look.name << ' ' << by.x << ' ' << by.y << ": " << found.by.x
                                    << ' ' << found.by.y;
            EXPECT_GT(found.explained, 0.9);
            EXPECT_NEAR(found.x_beyond, 0, 0.2);
            EXPECT_NEAR(found.y_beyond, 0, 0.2);
            EXPECT_FALSE(distortion_in(before, after, found.by)) << look.name;
        }
    }
}

TEST(FindShift, other_pictures_explain_little) {
    const Picture before = taken(240, 160, as_it_is, in_place);
    const Picture other = taken(240, 160, as_it_is, [](double x, double y) {
        return std::pair(3 * y + 5000, 2 * x - 900);
    });
    EXPECT_LT(find_shift(before, other).explained, 0.6);
}

TEST(FindShift, says_what_is_left_of_a_pixel) {
    const auto soft = [](double x, double y) {
        return RgbD{0.5 + 0.3 * std::sin(x / 5), 0.5 + 0.3 * std::cos(y / 6), 0.5};
    };
    Picture before{200, 160, {}}, after = before;
    for (int y = 0; y < 160; ++y) {
        for (int x = 0; x < 200; ++x) {
            before.pixels.push_back(to_float(soft(x, y) + 0.1 * scene(x, y)));
            after.pixels.push_back(to_float(0.8 * (soft(x - 0.4, y) + 0.1 * scene(x, y))));
        }
    }
    const Shift found = find_shift(before, after);
    EXPECT_NEAR(found.by.x + found.x_beyond, 0.4, 0.15);
    EXPECT_NEAR(found.y_beyond, 0, 0.1);
}

TEST(FindShift, a_picture_that_was_enlarged_is_distorted) {
    const Picture before = taken(240, 160, as_it_is, in_place);
    const Picture after = taken(240, 160, as_it_is, [](double x, double y) {
        return std::pair(120 + (x - 120) / 1.03, 80 + (y - 80) / 1.03);
    });
    const Shift found = find_shift(before, after);
    const std::optional<Pixel> apart = distortion_in(before, after, found.by);
    ASSERT_TRUE(apart);
    EXPECT_GE(apart->x, 3);
    EXPECT_GE(apart->y, 2);
}

TEST(FindShift, leaves_what_cannot_be_told_unmoved) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    for (const Picture& odd : {Picture{1, 1, {{0.5F, 0.5F, 0.5F}}}, Picture{1, 1, {{nan, 0, 0}}},
                               Picture{64, 64, std::vector<Rgb>(64 * 64, Rgb{0.3F, 0.4F, 0.5F})},
                               Picture{64, 64, std::vector<Rgb>(64 * 64, Rgb{nan, nan, nan})}}) {
        const Shift found = find_shift(odd, odd);
        EXPECT_EQ(found.by, Pixel{});
        EXPECT_EQ(found.explained, found.explained_unmoved);
    }
}

TEST(MovedBack, puts_each_pixel_where_it_was_and_leaves_the_rest_open) {
    const Picture before = taken(40, 30, as_it_is, in_place);
    const Picture after =
        taken(40, 30, as_it_is, [](double x, double y) { return std::pair(x - 3, y + 2); });
    const Picture back = moved_back(after, {3, -2});
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            if (x + 3 < 40 && y - 2 >= 0) {
                EXPECT_EQ(back.at(x, y), before.at(x, y));
            } else {
                EXPECT_TRUE(std::isnan(back.at(x, y).g));
            }
        }
    }
}

} // namespace
} // namespace lutlib
