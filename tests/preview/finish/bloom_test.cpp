// Bloom plans without a GPU: what each method does to light, in double, against exact convolution.
#include "preview/finish/blooms.h"
#include "preview/reference/bloom.h"
#include "preview/reference/convolution.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>
#include <string>

namespace preview {
namespace {

using lutlib::RgbD;
using reference::Image;

double sum_of(const Image& image) {
    double sum = 0;
    for (const RgbD& pixel : image.pixels) {
        sum += pixel.r + pixel.g + pixel.b;
    }
    return sum;
}

// A black picture with light only near its middle, so far from the border that no kernel gets
// there.
Image padded_lights(int size) {
    Image image(size, size);
    const int middle = size / 2;
    image.at(middle, middle) = {900, 500, 100};
    image.at(middle + 5, middle - 3) = {0.2, 3, 1};
    for (int y = -2; y <= 2; ++y) {
        for (int x = 9; x <= 14; ++x) {
            image.at(middle + x, middle + y) = {1.2, 0.4, 0.7};
        }
    }
    return image;
}

/// What a display can show, light up to 1, does not bloom.
constexpr BloomSettings above_one{-1, 1.25F, 0.25F, 1};

BloomPlan plan_for(const Bloom& bloom, const Image& image,
                   const BloomSettings& settings = above_one) {
    return bloom_plan(bloom, {image.width, image.height}, settings);
}

// Kernels that reach 5 sigma within a picture of 768 lines with light in its middle.
constexpr BloomSettings small_radius{-1, 1, 0.5F, 0.4F};

class EveryBloom : public testing::TestWithParam<const Bloom*> {};

TEST_P(EveryBloom, conserves_energy_where_it_says_so) {
    if (!GetParam()->conserves_energy) {
        GTEST_SKIP() << "does not claim to";
    }
    const Image image = padded_lights(768);
    for (const float threshold : {0.0F, 1.0F}) {
        BloomSettings settings = small_radius;
        settings.threshold = threshold;
        const Image out = reference::with_bloom(plan_for(*GetParam(), image, settings), image);
        EXPECT_NEAR(sum_of(out) / sum_of(image), 1, 1e-3) << threshold;
    }
}

TEST_P(EveryBloom, keeps_constant_light_constant_up_to_the_border) {
    Image image(135, 67);
    for (RgbD& pixel : image.pixels) {
        pixel = {3, 2, 1};
    }
    const Image out = reference::with_bloom(plan_for(*GetParam(), image), image);
    for (const RgbD& pixel : out.pixels) {
        ASSERT_NEAR(pixel.r, 3, 1e-5);
        ASSERT_NEAR(pixel.b, 1, 1e-5);
    }
}

TEST_P(EveryBloom, leaves_light_below_its_onset_alone) {
    Image image(40, 30);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = {static_cast<double>(i) / 1199, 0.1, 0.99};
    }
    const Image out = reference::with_bloom(plan_for(*GetParam(), image), image);
    EXPECT_EQ(bloom_onset(above_one), 1);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        ASSERT_EQ(out.pixels[i], image.pixels[i]);
    }
}

TEST_P(EveryBloom, stays_bounded_for_the_brightest_single_texel) {
    for (const auto& [width, height] : {std::pair{135, 67}, {1, 1}, {2, 3}, {320, 180}}) {
        Image image(width, height);
        image.at(width / 2, height / 2) = {65504, 65504, 65504};
        const Image out = reference::with_bloom(plan_for(*GetParam(), image), image);
        for (const RgbD& pixel : out.pixels) {
            ASSERT_GE(pixel.g, 0);
            ASSERT_LE(pixel.g, 65504 * (1 + 1e-6));
        }
    }
}

// The centre of mass of the bloom of one texel is that texel, wherever it sits in the pyramid.
TEST_P(EveryBloom, does_not_shift_in_odd_sizes) {
    for (const int place : {60, 61, 62, 63}) {
        Image image(135, 67 + 64);
        image.at(place, 61) = {100, 100, 100};
        const BloomPlan plan = plan_for(*GetParam(), image, {-1, 0, 0, 0.3F});
        if (plan.empty()) {
            return;
        }
        const Image out = reference::bloom(plan, image);
        double x = 0, total = 0;
        for (int v = 0; v < out.height; ++v) {
            for (int u = 0; u < out.width; ++u) {
                x += u * out.at(u, v).g;
                total += out.at(u, v).g;
            }
        }
        // A fiftieth of a texel: what the kernels' tails lose at the border. The Karis average,
        // which is not linear, weighs the parts of one texel's light apart.
        EXPECT_NEAR(x / total, place, GetParam()->conserves_energy ? 0.02 : 0.1) << place;
    }
}

TEST_P(EveryBloom, has_a_plan_that_the_shaders_can_hold) {
    for (const BloomExtent size : {BloomExtent{1, 1}, {135, 67}, {1920, 1080}, {7680, 4320}}) {
        for (const float radius : {0.1F, 1.0F, 4.0F}) {
            const BloomPlan plan = bloom_plan(*GetParam(), size, {-1, 1, 0.5F, radius});
            for (const BloomStep& step : plan.steps) {
                ASSERT_LE(step.taps.size(), std::size_t{BloomPlan::max_taps});
                double sum = static_cast<double>(step.keep);
                for (std::size_t i = 0; i < step.taps.size(); ++i) {
                    sum += (step.axis != BloomStep::Axis::both && i > 0 ? 2.0 : 1.0) *
                           static_cast<double>(step.taps[i].weight);
                }
                ASSERT_NEAR(sum, 1, 1e-5);
            }
            ASSERT_LE(plan.last.taps.size(), std::size_t{BloomPlan::max_final_taps});
            double sum = 0;
            for (const BloomTap& tap : plan.last.taps) {
                sum += static_cast<double>(tap.weight);
            }
            ASSERT_NEAR(sum, plan.empty() ? 0 : 1, 1e-5);
        }
    }
}

std::vector<const Bloom*> every_bloom() {
    std::vector<const Bloom*> rows;
    for (const Bloom& row : blooms()) {
        rows.push_back(&row);
    }
    return rows;
}

INSTANTIATE_TEST_SUITE_P(Table, EveryBloom, testing::ValuesIn(every_bloom()),
                         [](const auto& row) { return support::test_name(row.param->name); });

double relative_error(const Image& a, const Image& b) {
    double error = 0, total = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        error += (a.pixels[i].g - b.pixels[i].g) * (a.pixels[i].g - b.pixels[i].g);
        total += b.pixels[i].g * b.pixels[i].g;
    }
    return std::sqrt(error / total);
}

TEST(Bloom, of_one_gaussian_is_its_exact_convolution) {
    Image image(270, 270);
    image.at(133, 140) = {50, 50, 50};
    image.at(90, 71) = {20, 20, 20};
    // 14 texels at 1080 lines.
    const double sigma = 14.0 * 270 / 1080;
    const BloomPlan plan = plan_for(*bloom_named("gaussian"), image, {-1, 0, 0, 1});
    const Image exact = reference::convolved(
        image, 24, [&](double dx, double dy) { return reference::gaussian(dx, dy, sigma); });
    // What the pyramid's kernel differs from a Gaussian of the same variance by.
    EXPECT_LT(relative_error(reference::bloom(plan, image), exact), 0.03);
}

TEST(Bloom, of_the_veiling_glare_is_its_exact_convolution) {
    Image image(540, 540);
    image.at(271, 262) = {5000, 5000, 5000};
    for (int y = 200; y < 212; ++y) {
        for (int x = 300; x < 330; ++x) {
            image.at(x, y) = {40, 40, 40};
        }
    }
    const double scale = 540.0 / 1080;
    const BloomPlan plan = plan_for(*bloom_named("glare"), image, {-1, 0, 0, 1});
    const Image exact = reference::convolved(image, 520, [&](double dx, double dy) {
        const auto g = [&](double sigma) { return reference::gaussian(dx, dy, sigma * scale); };
        return 0.1 * g(6.2) + 0.012 * g(24.9) + 0.0027 * g(81) + 0.001 * g(263);
    });
    EXPECT_LT(relative_error(reference::bloom(plan, image), exact), 0.03);
}

TEST(Convolution, of_a_gaussian_with_a_gaussian_adds_their_variances) {
    Image image(96, 96);
    for (int y = 0; y < 96; ++y) {
        for (int x = 0; x < 96; ++x) {
            image.at(x, y).g = reference::gaussian(x - 48, y - 48, 3);
        }
    }
    const Image wide = reference::convolved(
        image, 40, [](double dx, double dy) { return reference::gaussian(dx, dy, 4); });
    EXPECT_NEAR(wide.at(48, 48).g, reference::gaussian(0, 0, 5), 1e-9);
    EXPECT_NEAR(wide.at(52, 45).g, reference::gaussian(4, 3, 5), 1e-9);
}

} // namespace
} // namespace preview
