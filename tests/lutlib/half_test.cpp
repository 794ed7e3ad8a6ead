#include "lutlib/half.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace lutlib {
namespace {

constexpr int sign = 0x8000, infinity = 0x7C00, largest = 0x7BFF;

TEST(Half, every_finite_half_is_the_half_of_its_float) {
    for (int half = 0; half <= 0xFFFF; ++half) {
        const float value = float_from_half(static_cast<std::uint16_t>(half));
        if (std::isfinite(value)) {
            ASSERT_EQ(half_from(value), half);
            ASSERT_EQ(std::signbit(value), half >= sign);
        }
    }
}

TEST(Half, floats_rise_with_their_halves_and_have_the_published_corners) {
    for (int half = 0; half < infinity; ++half) {
        ASSERT_LT(float_from_half(static_cast<std::uint16_t>(half)),
                  float_from_half(static_cast<std::uint16_t>(half + 1)));
    }
    EXPECT_EQ(float_from_half(0), 0);
    EXPECT_EQ(float_from_half(1), std::ldexp(1.0F, -24));
    EXPECT_EQ(float_from_half(0x0400), std::ldexp(1.0F, -14));
    EXPECT_EQ(float_from_half(0x3C00), 1);
    EXPECT_EQ(float_from_half(0xC000), -2);
    EXPECT_EQ(float_from_half(0x3555), 0.333251953125F);
    EXPECT_EQ(float_from_half(largest), 65504);
    EXPECT_EQ(float_from_half(infinity), std::numeric_limits<float>::infinity());
    EXPECT_EQ(float_from_half(infinity | sign), -std::numeric_limits<float>::infinity());
    for (int half = infinity + 1; half < sign; ++half) {
        ASSERT_TRUE(std::isnan(float_from_half(static_cast<std::uint16_t>(half))));
        ASSERT_TRUE(std::isnan(float_from_half(static_cast<std::uint16_t>(half | sign))));
    }
}

TEST(Half, rounds_to_the_nearest_and_ties_to_even_between_all_neighbours) {
    for (int half = 0; half < largest; ++half) {
        const double low = float_from_half(static_cast<std::uint16_t>(half));
        const double high = float_from_half(static_cast<std::uint16_t>(half + 1));
        const double middle = (low + high) / 2;
        const int even = half % 2 == 0 ? half : half + 1;
        ASSERT_EQ(half_from(middle), even);
        ASSERT_EQ(half_from(std::nextafter(middle, low)), half);
        ASSERT_EQ(half_from(std::nextafter(middle, high)), half + 1);
        ASSERT_EQ(half_from(-middle), even | sign);
    }
}

TEST(Half, near_a_picture_s_sample_is_the_same_quickly) {
    std::mt19937 random(1);
    const auto expect_same = [](float value) {
        const bool is_large = std::abs(value) > 65504;
        const float held = is_large ? std::copysign(65504.0F, value) : value;
        ASSERT_EQ(half_near(value), half_from(static_cast<double>(held))) << value;
    };
    for (int i = 0; i < 1'000'000; ++i) {
        const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (std::isfinite(value)) {
            expect_same(value);
        }
    }
    for (int half = 0; half < largest; ++half) {
        const float low = float_from_half(static_cast<std::uint16_t>(half));
        const float high = float_from_half(static_cast<std::uint16_t>(half + 1));
        const float middle = low + (high - low) / 2;
        for (const float value :
             {low, middle, std::nextafter(middle, low), std::nextafter(middle, high), -middle}) {
            expect_same(value);
        }
    }
    constexpr float endless = std::numeric_limits<float>::infinity();
    EXPECT_EQ(float_from_half(half_near(endless)), endless);
    EXPECT_EQ(float_from_half(half_near(-endless)), -endless);
    EXPECT_TRUE(std::isnan(float_from_half(half_near(std::nanf("")))));
}

TEST(Half, holds_what_is_too_large_and_takes_nan_for_0) {
    constexpr double endless = std::numeric_limits<double>::infinity();
    for (const double value : {65504.0, 65505.0, 65520.0, 1e300, endless}) {
        EXPECT_EQ(half_from(value), largest);
        EXPECT_EQ(half_from(-value), largest | sign);
    }
    EXPECT_EQ(half_from(std::nan("")), 0);
    EXPECT_EQ(half_from(-0.0), sign);
    EXPECT_EQ(half_from(std::ldexp(1.0, -25)), 0);
    EXPECT_EQ(half_from(std::nextafter(std::ldexp(1.0, -25), 1.0)), 1);
}

} // namespace
} // namespace lutlib
