// The exact glow that blooms are held against.
#include "preview/reference/bloom.h"
#include "preview/report/bloom_kernel.h"
#include "preview/report/errors.h"

#include <gtest/gtest.h>

namespace preview::report {
namespace {

using lutlib::RgbD;
using reference::Image;

constexpr BloomSettings all_light{1, 0, 0, 1};

double sum_of(const Image& image) {
    double sum = 0;
    for (const RgbD& pixel : image.pixels) {
        sum += pixel.g;
    }
    return sum;
}

TEST(ExactGlow, of_constant_light_is_that_light) {
    for (const Bloom& bloom : blooms()) {
        Image light(61, 47);
        for (RgbD& pixel : light.pixels) {
            pixel = {3, 2, 1};
        }
        const Image glow = exact_glow(bloom, all_light, light);
        const double wanted = bloom_plan(bloom, {61, 47}, all_light).empty() ? 0 : 2;
        EXPECT_NEAR(glow.at(30, 20).g, wanted, 1e-9) << bloom.name;
        EXPECT_NEAR(glow.at(0, 46).g, wanted, 1e-9) << bloom.name;
    }
}

// Steps of a pyramid are no convolution, but near one: the plan itself, in double.
TEST(ExactGlow, is_what_each_plan_comes_to) {
    for (const Bloom& bloom : blooms()) {
        if (bloom.plan({64, 64}, {}).empty()) {
            continue;
        }
        Image light(135, 108);
        light.at(60, 51) = {40, 50, 60};
        for (int y = 30; y < 42; ++y) {
            for (int x = 80; x < 95; ++x) {
                light.at(x, y) = {4, 4, 4};
            }
        }
        BloomSettings wide = all_light;
        wide.radius = 3; // wide enough for a pyramid
        const BloomPlan plan = bloom_plan(bloom, {135, 108}, wide);
        Image glow = reference::bloom(plan, light);
        const PassError error = pass_error(glow, exact_glow(bloom, wide, light));
        EXPECT_LT(error.relative_l2, bloom.conserves_energy ? 0.12 : 0.4) << bloom.name;
        if (bloom.conserves_energy) {
            EXPECT_NEAR(error.drift, 0, 0.02) << bloom.name;
        }
    }
}

TEST(ExactGlow, takes_the_prefilter_and_the_strength) {
    Image dim(48, 40);
    for (RgbD& pixel : dim.pixels) {
        pixel = {0.9, 0.8, 0.7};
    }
    const Bloom& glare = *bloom_named("glare");
    const BloomSettings above_one{0.25F, 1.25F, 0.25F, 1};
    EXPECT_EQ(sum_of(exact_glow(glare, above_one, dim)), 0);
    dim.at(24, 20) = {100, 100, 100};
    const Image glow = exact_glow(glare, above_one, dim);
    EXPECT_GT(sum_of(glow), 1);
    const Image all = with_glow(glare, above_one, dim, glow);
    EXPECT_LT(all.at(24, 20).g, 100);
    EXPECT_EQ(with_glow(*bloom_named("none"), above_one, dim, Image(48, 40)).pixels, dim.pixels);
}

} // namespace
} // namespace preview::report
