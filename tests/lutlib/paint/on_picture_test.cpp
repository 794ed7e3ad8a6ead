#include "lutlib/paint/on_picture.h"

#include "lutlib/color/difference.h"
#include "lutlib/error.h"
#include "tests/lutlib/paint/shots.h"

#include <gtest/gtest.h>

#include <limits>

namespace lutlib {
namespace {

const Area nothing{};

std::string edits_of(const OnPicture& on) {
    std::string out;
    for (const std::string& edit : on.edits) {
        out += edit + "\n";
    }
    return out;
}

TEST(OnPicture, is_the_dE2000_of_each_pixel_and_leaves_the_strip_out) {
    const Picture before = screenshot(90, 60);
    Picture after = graded(before, warm_look());
    after.at(7, 9) = {1, 0, 0};
    after.at(50, 30) = {0, 1, 0};
    const Area except{40, 20, 60, 40};
    const OnPicture on = on_picture(before, after, except, warm_look());
    EXPECT_EQ(on.delta_e_2000.count, 90U * 60 - 20 * 20);
    const double right =
        delta_e_2000(warm_look()(to_double(before.at(7, 9))), to_double(after.at(7, 9)));
    EXPECT_NEAR(on.delta_e_2000.max, right, 1e-6);
    EXPECT_NEAR(on.map[9 * 90 + 7], right, 1e-4);
    EXPECT_LT(on.map[30 * 90 + 50], 0);
    // Rounding to 8 bits.
    EXPECT_LT(on.delta_e_2000.mean, 0.3);
    EXPECT_EQ(edits_of(on), "");
}

TEST(OnPicture, takes_a_picture_that_grew_by_what_was_placed_beside_it) {
    const Picture before = screenshot(90, 60);
    Picture after = screenshot(90, 100);
    put(after, graded(before, warm_look()), {0, 0});
    EXPECT_LT(on_picture(before, after, {0, 60, 90, 100}, warm_look()).delta_e_2000.max, 1);
    EXPECT_THROW(on_picture(before, after, {0, 0, 90, 100}, warm_look()), Error);
}

TEST(OnPicture, names_a_part_that_was_edited_by_itself_and_where) {
    const Picture before = screenshot(320, 200);
    Picture after = graded(before, warm_look());
    for (int y = 64; y < 96; ++y) {
        for (int x = 160; x < 224; ++x) {
            after.at(x, y).r *= 0.8F;
        }
    }
    const std::string edits = edits_of(on_picture(before, after, nothing, warm_look()));
    EXPECT_NE(edits.find("between x 160 and 224, y 64 and 96"), std::string::npos) << edits;
    const std::vector<Area> parts = on_picture(before, after, nothing, warm_look()).parts;
    ASSERT_EQ(parts.size(), 8U);
    EXPECT_EQ(parts.front().left, 160);
    EXPECT_EQ(parts.back().bottom, 96);
}

TEST(OnPicture, takes_noise_that_spares_the_mean_of_a_place_for_no_edit) {
    const Picture before = screenshot(320, 200);
    Picture after = graded(before, warm_look());
    for (int y = 64; y < 96; ++y) {
        for (int x = 160; x < 224; ++x) {
            const float wave = (x / 2 + y / 2) % 2 == 0 ? 0.06F : -0.06F;
            after.at(x, y) = after.at(x, y) + Rgb{wave, -wave, wave};
        }
    }
    const OnPicture on = on_picture(before, after, nothing, warm_look());
    EXPECT_TRUE(on.parts.empty()) << edits_of(on);
    EXPECT_GT(on.map[80 * 320 + 200], 2);
}

TEST(OnPicture, leaves_out_pixels_that_are_no_numbers) {
    const Picture before = screenshot(90, 60);
    Picture after = graded(before, warm_look());
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    after.at(7, 9) = {nan, nan, nan};
    after.at(8, 9).g = std::numeric_limits<float>::infinity();
    const OnPicture on = on_picture(before, after, nothing, warm_look());
    EXPECT_EQ(on.delta_e_2000.count, 90U * 60 - 2);
    EXPECT_LT(on.delta_e_2000.max, 1);
    EXPECT_LT(on.map[9 * 90 + 7], 0);
}

TEST(OnPicture, names_a_vignette) {
    const Picture before = screenshot(320, 200);
    Picture after = graded(before, warm_look());
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 320; ++x) {
            const double u = x / 160.0 - 1, v = y / 100.0 - 1;
            after.at(x, y) = after.at(x, y) * static_cast<float>(1 - 0.2 * (u * u + v * v));
        }
    }
    const std::string edits = edits_of(on_picture(before, in_codes(after), nothing, warm_look()));
    EXPECT_NE(edits.find("darker towards its corners"), std::string::npos) << edits;
}

TEST(OnPicture, names_sharpening_and_blurring) {
    const Picture before = noisy(screenshot(320, 200), 6);
    const Picture after = graded(before, warm_look());
    const std::string sharp =
        edits_of(on_picture(before, blurred(after, -0.4F), nothing, warm_look()));
    EXPECT_NE(sharp.find("sharpened"), std::string::npos) << sharp;
    const std::string soft =
        edits_of(on_picture(before, blurred(after, 0.4F), nothing, warm_look()));
    EXPECT_NE(soft.find("blurred"), std::string::npos) << soft;
}

} // namespace
} // namespace lutlib
