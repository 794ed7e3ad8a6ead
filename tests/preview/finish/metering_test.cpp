#include "preview/finish/metering.h"

#include "lutlib/half.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace preview {
namespace {

std::vector<std::uint16_t> halves(std::initializer_list<float> values) {
    std::vector<std::uint16_t> out;
    for (const float value : values) {
        out.push_back(lutlib::half_near(value));
    }
    return out;
}

TEST(Metering, brings_one_light_to_18_percent_by_its_luma) {
    EXPECT_NEAR(stops_to_grey(lutlib::RgbD{0.18, 0.18, 0.18}).value(), 0, 1e-12);
    EXPECT_NEAR(stops_to_grey(lutlib::RgbD{0.72, 0.72, 0.72}).value(), -2, 1e-12);
    // Green has 0.7152 of white's luma.
    EXPECT_NEAR(stops_to_grey(lutlib::RgbD{0, 0.18, 0}).value(), -std::log2(0.7152), 1e-12);
    EXPECT_FALSE(stops_to_grey(lutlib::RgbD{0, 0, 0}));
    EXPECT_FALSE(stops_to_grey(lutlib::RgbD{NAN, 1, 1}));
    EXPECT_FALSE(stops_to_grey(lutlib::RgbD{std::numeric_limits<double>::infinity(), 1, 1}));
}

TEST(Metering, of_a_picture_takes_the_mean_of_stops_not_of_light) {
    // Half of it at 1/4, half at 4: in stops their mean is 1.
    const auto both = halves({0.25F, 0.25F, 0.25F, 1, 4, 4, 4, 1});
    EXPECT_NEAR(stops_to_grey(both).value(), std::log2(0.18), 1e-6);
    // Bars without light do not count; what is almost black counts as 2^-12.
    const auto half_black = halves({1, 1, 1, 1, 0, 0, 0, 1});
    EXPECT_NEAR(stops_to_grey(half_black).value(), std::log2(0.18), 1e-6);
    const auto half_dark = halves({1, 1, 1, 1, 1e-6F, 1e-6F, 1e-6F, 1});
    EXPECT_NEAR(stops_to_grey(half_dark).value(), std::log2(0.18) + 6, 1e-6);
    EXPECT_FALSE(stops_to_grey(halves({0, 0, 0, 1})));
    EXPECT_FALSE(stops_to_grey(std::vector<std::uint16_t>{}));
}

} // namespace
} // namespace preview
