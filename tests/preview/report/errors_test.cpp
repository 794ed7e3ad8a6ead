// How errors are measured, on images whose errors are known.
#include "preview/report/errors.h"
#include "preview/report/test_pictures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace preview::report {
namespace {

using lutlib::RgbD;
using reference::Image;

Image filled(int width, int height, RgbD color) {
    Image out(width, height);
    for (RgbD& pixel : out.pixels) {
        pixel = color;
    }
    return out;
}

Image image_of(const ShownPicture& picture) {
    Image out(static_cast<int>(picture.size.width), static_cast<int>(picture.size.height));
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.pixels[i][c] = static_cast<double>(picture.rgba[4 * i + c]);
        }
    }
    return out;
}

TEST(PassError, is_relative_and_signs_its_drift) {
    const Image wanted = filled(4, 3, {2, 1, 4});
    Image got = wanted;
    for (RgbD& pixel : got.pixels) {
        pixel = {2.02, 0.97, 4};
    }
    const PassError error = pass_error(got, wanted);
    EXPECT_NEAR(error.relative_l2, std::sqrt((0.02 * 0.02 + 0.03 * 0.03) / 21), 1e-12);
    EXPECT_NEAR(error.drift, -0.03, 1e-12);
    EXPECT_FALSE(error.asymmetry || error.centroid_shift);
    EXPECT_EQ(pass_error(wanted, wanted).relative_l2, 0);
}

TEST(PassError, of_an_impulse_sees_what_is_not_round_and_what_has_moved) {
    constexpr Size middle{16, 15};
    Image round(33, 31), square(33, 31), moved(33, 31);
    for (int y = 0; y < 31; ++y) {
        for (int x = 0; x < 33; ++x) {
            const auto light = [&](double dx) {
                const double r2 = (x - 16 - dx) * (x - 16 - dx) + (y - 15) * (y - 15);
                return std::exp(-r2 / 18);
            };
            round.at(x, y) = RgbD{1, 1, 1} * light(0);
            moved.at(x, y) = RgbD{1, 1, 1} * light(0.5);
            square.at(x, y) = std::abs(x - 16) < 5 && std::abs(y - 15) < 5 ? RgbD{1, 1, 1} : RgbD{};
        }
    }
    const PassError of_round = pass_error(round, round, middle);
    EXPECT_LT(*of_round.asymmetry, 0.05);
    EXPECT_EQ(*of_round.centroid_shift, 0);
    EXPECT_GT(*pass_error(square, round, middle).asymmetry, 0.25);
    EXPECT_NEAR(*pass_error(moved, round, middle).centroid_shift, 0.5, 1e-3);
}

TEST(PictureError, is_none_between_equals_and_finds_the_worst_pixel) {
    const Image wanted = filled(10, 10, {0.5, 0.5, 0.5});
    Image got = wanted;
    EXPECT_EQ(picture_error(got, wanted).delta_e_2000.max, 0);
    got.at(3, 7) = {0.5, 0.75, 0.5};
    const PictureError error = picture_error(got, wanted);
    EXPECT_DOUBLE_EQ(error.largest, 0.25);
    EXPECT_GT(error.delta_e_2000.max, 10);
    EXPECT_NEAR(error.delta_e_2000.mean, error.delta_e_2000.max / 100, 1e-9);
    EXPECT_EQ(error.delta_e_2000.p99, 0);
    EXPECT_GT(error.delta_e_itp.max, 1);
}

TEST(Unrest, is_none_of_what_only_moves) {
    for (const TestPicture& picture : test_pictures()) {
        if (picture.name == "sun disc" || picture.name == "ramps") {
            continue; // a ramp ends at a border
        }
        std::vector<Image> frames;
        for (int k = 0; k < 4; ++k) {
            frames.push_back(image_of(picture.make({64, 36}, 2 * k)));
        }
        EXPECT_LT(unrest(frames, 2), 1e-9) << picture.name;
        frames[2].at(30, 18) = frames[2].at(30, 18) + RgbD{0, 100, 0};
        EXPECT_GT(unrest(frames, 2), 1e-3) << picture.name;
    }
}

TEST(UnrestOfError, is_none_of_an_error_that_stays) {
    const Image wanted = filled(5, 4, {1, 2, 3});
    const Image off = filled(5, 4, {1.5, 2, 3});
    const std::vector<Image> truth{wanted, wanted}, stays{off, off}, comes{wanted, off};
    EXPECT_EQ(unrest_of_error(stays, truth), 0);
    // Half of the error on either side of its mean, in both frames.
    EXPECT_NEAR(unrest_of_error(comes, truth), std::sqrt(2 * 0.25 * 0.25 / (2 * 14)), 1e-12);
}

TEST(Averaged, is_the_mean_of_each_square) {
    Image large(6, 4);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 6; ++x) {
            large.at(x, y).g = 10 * y + x;
        }
    }
    const Image small = averaged(large, 2);
    ASSERT_EQ(small.width, 3);
    ASSERT_EQ(small.height, 2);
    EXPECT_DOUBLE_EQ(small.at(0, 0).g, 5.5);
    EXPECT_DOUBLE_EQ(small.at(2, 1).g, 29.5);
}

TEST(TestPictures, are_of_every_size_and_finite) {
    for (const TestPicture& picture : test_pictures()) {
        for (const Size size : {Size{16, 16}, {33, 17}, {128, 72}}) {
            const ShownPicture made = picture.make(size, 3);
            ASSERT_EQ(made.size, size);
            ASSERT_EQ(made.rgba.size(), std::size_t{4} * size.width * size.height);
            float largest = 0;
            for (const float value : made.rgba) {
                ASSERT_TRUE(value >= 0 && value <= 65504) << picture.name;
                largest = std::max(largest, value);
            }
            EXPECT_GT(largest, 1.2F) << picture.name << " has nothing that blooms";
        }
    }
}

} // namespace
} // namespace preview::report
