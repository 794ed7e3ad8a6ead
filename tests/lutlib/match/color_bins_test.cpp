#include "lutlib/match/color_bins.h"
#include "tests/lutlib/match/pairs.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <numeric>

namespace lutlib {
namespace {

const auto halved = [](RgbD c) { return 0.5 * c; };

TEST(ColorBins, mean_what_a_map_of_their_pixels_means) {
    const std::vector<PixelPair> pixels = picture_pairs(halved, 20000);
    constexpr int side = 16;
    struct Sum {
        RgbD before, after;
        double count = 0;
    };
    std::map<std::vector<int>, Sum> wanted;
    for (const PixelPair& pixel : pixels) {
        std::vector<int> key;
        for (const std::size_t c : {2U, 1U, 0U}) {
            key.push_back(
                std::min(side - 1, static_cast<int>(pixel.before[c] * static_cast<float>(side))));
        }
        Sum& sum = wanted[key];
        sum = {sum.before + to_double(pixel.before), sum.after + to_double(pixel.after),
               sum.count + 1};
    }
    const ColorBins bins(pixels, side);
    const std::vector<ColorPair> means = bins.means();
    ASSERT_EQ(means.size(), wanted.size());
    std::size_t i = 0;
    for (const auto& [key, sum] : wanted) {
        EXPECT_EQ(means[i].weight, sum.count);
        EXPECT_LT(largest_magnitude(means[i].before - 1 / sum.count * sum.before), 1e-12);
        EXPECT_LT(largest_magnitude(means[i].after - 1 / sum.count * sum.after), 1e-12);
        ++i;
    }
}

TEST(ColorBins, leave_out_pixels_that_are_no_numbers_and_hold_those_beyond_the_cube) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    infinite = std::numeric_limits<float>::infinity();
    const ColorBins bins({{{nan, 0, 0}, {0, 0, 0}},
                          {{0, 0, 0}, {0, infinite, 0}},
                          {{-3, 0.5F, 7}, {1, 1, 1}},
                          {{1, 1, 1}, {1, 1, 1}}},
                         256);
    EXPECT_EQ(bins.pixels(), 2U);
    EXPECT_EQ(bins.size(), 2U);
    EXPECT_EQ(ColorBins({}, 4).size(), 0U);
    EXPECT_TRUE(ColorBins({}, 4).means().empty());
}

TEST(ColorBins, channels_whose_codes_end_stand_apart_from_those_that_do_not) {
    const std::vector<PixelPair> pixels{{{0.5F, 0.5F, 0.5F}, {1, 0.5F, 0.5F}},
                                        {{0.51F, 0.5F, 0.5F}, {1, 0.6F, 0}},
                                        {{0.52F, 0.5F, 0.5F}, {0.9F, 0.5F, 0.5F}},
                                        {{0.53F, 0.5F, 0.5F}, {0.8F, 0.5F, 0.5F}}};
    EXPECT_EQ(ColorBins(pixels, 1).size(), 1U);
    const std::vector<ColorPair> means = ColorBins(pixels, 1, true).means();
    ASSERT_EQ(means.size(), 3U);
    EXPECT_EQ(means[0].clipped, (Clipped{0, 0, 0}));
    EXPECT_EQ(means[0].weight, 2);
    EXPECT_NEAR(means[0].after.r, 0.85, 1e-7);
    EXPECT_EQ(means[1].clipped, (Clipped{1, 0, -1}));
    EXPECT_EQ(means[2].clipped, (Clipped{1, 0, 0}));
    // Beyond the end of the codes nothing is off.
    EXPECT_EQ(off_by({1, 0.5, 0}, {1.2, 0.4, -0.1}, {1, 0, -1}), (RgbD{0, 0.5 - 0.4, 0}));
    EXPECT_EQ(off_by({1, 0, 0}, {0.5, 0.25, 0.25}, {1, -1, 0}), (RgbD{0.5, -0.25, -0.25}));
}

TEST(ColorBins, tetrahedra_of_the_lattice_stand_apart_so_that_its_results_have_exact_means) {
    const auto bent = [](RgbD c) { return RgbD{std::max(c.r, c.g), std::min(c.g, c.b), c.b}; };
    std::vector<PixelPair> pixels;
    for (PixelPair pixel : picture_pairs(halved, 20000)) {
        pixel.after = to_float(bent(to_double(pixel.before)));
        pixels.push_back(pixel);
    }
    const auto off = [&bent](const std::vector<ColorPair>& means) {
        double most = 0;
        for (const ColorPair& mean : means) {
            most = std::max(most, largest_magnitude(mean.after - bent(mean.before)));
        }
        return most;
    };
    const std::vector<ColorPair> apart = ColorBins(pixels, 16, false, 9).means(),
                                 together = ColorBins(pixels, 16).means();
    EXPECT_LT(off(apart), 1e-6);
    EXPECT_GT(off(together), 1e-3);
    EXPECT_GT(apart.size(), together.size());
}

TEST(ColorBins, pixels_of_one_colour_tell_no_more_than_one_of_what_rounding_took) {
    std::vector<PixelPair> pixels(1000, {{0.5F, 0.5F, 0.5F}, {0.5F, 0.5F, 0.5F}});
    pixels.push_back({{0.51F, 0.5F, 0.5F}, {0.52F, 0.5F, 0.5F}});
    const ColorBins bins(pixels, 1, true);
    const Transform same;
    const ColorPair rounded = bins.robust_means(same, 0.1, {0.001, 0})[0];
    EXPECT_NEAR(rounded.weight, 2, 0.05);
    EXPECT_NEAR(rounded.before.r, 0.505, 1e-4);
    const ColorPair noisy = bins.robust_means(same, 0.1, {0, 0.001})[0];
    EXPECT_NEAR(noisy.weight, 1001, 1);
}

TEST(ColorBins, robust_means_do_not_hear_a_tenth_that_strays) {
    std::vector<PixelPair> pixels = picture_pairs(halved, 40000);
    for (std::size_t i = 0; i < pixels.size(); i += 10) {
        pixels[i].after = {0.9F, 0.1F, 0.9F};
    }
    const ColorBins bins(pixels, 8);
    const Transform look = Transform::each(halved);
    double plain = 0, robust = 0;
    const std::vector<ColorPair> means = bins.means(), kept = bins.robust_means(look, 4.0 / 255);
    ASSERT_EQ(means.size(), kept.size());
    for (std::size_t i = 0; i < means.size(); ++i) {
        if (means[i].weight >= 50) {
            plain = std::max(plain, largest_magnitude(means[i].after - halved(means[i].before)));
            robust = std::max(robust, largest_magnitude(kept[i].after - halved(kept[i].before)));
        }
    }
    EXPECT_GT(plain, 10.0 / 255);
    // What rounding leaves in the mean of fifty, in the worst bin.
    EXPECT_LT(robust, 0.5 / 255);
}

TEST(ColorBins, noise_is_that_of_the_pixels_and_not_of_those_that_stray) {
    std::vector<PixelPair> pixels = picture_pairs(halved, 40000);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        // Evenly over a width, whose standard deviation by its median is 1.4826 / 4 of it.
        const double spread = static_cast<double>(i % 101) / 100 - 0.5;
        pixels[i].after.g += static_cast<float>(spread * 8 / 255);
        pixels[i].after.r = pixels[i].after.g;
        pixels[i].after.b = pixels[i].after.g;
        pixels[i].before = {pixels[i].before.g, pixels[i].before.g, pixels[i].before.g};
        if (i % 9 == 0) {
            pixels[i].after = {1, 0, 1};
        }
    }
    const ColorBins bins(pixels, 8);
    const double noise = 255 * bins.noise(Transform::each(halved));
    EXPECT_NEAR(noise, 8 * 1.4826 / 4, 0.4);
}

} // namespace
} // namespace lutlib
