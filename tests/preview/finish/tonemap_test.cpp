// Tone maps without a GPU: defined for every input, bounded, monotone.
#include "lutlib/color/transfer.h"
#include "preview/finish/tonemaps.h"
#include "tests/support/names.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace preview {
namespace {

using lutlib::RgbD;
using lutlib::srgb_decode;

class EveryTonemap : public testing::TestWithParam<const Tonemap*> {};

TEST_P(EveryTonemap, gives_0_to_1_for_every_input) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const double values[]{0, -0.0, 1e-30, 1e-5, 0.18, 0.5, 1, 7, 65504, 1e30, inf, -1, -inf, nan};
    for (const double r : values) {
        for (const double g : values) {
            for (const double b : values) {
                const RgbD out = GetParam()->apply({r, g, b});
                for (std::size_t c = 0; c < 3; ++c) {
                    ASSERT_GE(out[c], 0) << r << ' ' << g << ' ' << b;
                    ASSERT_LE(out[c], 1) << r << ' ' << g << ' ' << b;
                }
            }
        }
    }
}

TEST_P(EveryTonemap, maps_black_to_black_and_keeps_greys_grey_in_rising_order) {
    EXPECT_NEAR(GetParam()->apply({0, 0, 0}).g, 0, 2e-3);
    double last = -1;
    for (int i = -400; i <= 400; ++i) {
        const double light = std::exp2(i / 25.0);
        const RgbD out = GetParam()->apply({light, light, light});
        ASSERT_GE(out.g, last) << light;
        // The published matrices of Hill's and Sobotka's maps sum to 1 within their digits.
        ASSERT_NEAR(out.r, out.g, 2e-3) << light;
        ASSERT_NEAR(out.b, out.g, 2e-3) << light;
        last = out.g;
    }
    EXPECT_GT(last, 0.95);
}

TEST_P(EveryTonemap, is_found_by_its_name) {
    EXPECT_EQ(tonemap_named(GetParam()->name), GetParam());
}

TEST_P(EveryTonemap, is_a_curve_or_mixes_channels_in_a_shader_function_of_its_own) {
    const Tonemap& row = *GetParam();
    EXPECT_EQ(row.curve == nullptr, row.mix != nullptr);
    EXPECT_EQ(row.curve == nullptr, !row.shader.empty());
    for (const Tonemap& other : tonemaps()) {
        EXPECT_TRUE(&other == &row || row.shader.empty() || other.shader != row.shader);
    }
}

// What a shader makes of the table: in each octave a float's mantissa counts evenly.
double from_table(std::span<const float> nodes, double light) {
    int exponent = 0;
    const double mantissa =
        2 * std::frexp(std::max(light, std::ldexp(1, ToneCurve::lowest)), &exponent);
    const double at = (exponent - 1 - ToneCurve::lowest + mantissa - 1) * ToneCurve::nodes;
    const auto node = static_cast<std::size_t>(at);
    return std::min(std::lerp(static_cast<double>(nodes[node]),
                              static_cast<double>(nodes[node + 1]), at - std::floor(at)),
                    1.0);
}

TEST_P(EveryTonemap, has_a_table_within_a_200th_of_an_8_bit_code_if_it_is_a_curve) {
    const std::span<const float> nodes = tabulated_curve(*GetParam());
    if (GetParam()->curve == nullptr) {
        EXPECT_TRUE(nodes.empty());
        return;
    }
    ASSERT_EQ(nodes.size(), static_cast<std::size_t>(ToneCurve::size));
    double worst = 0, at = 0;
    for (int i = -40 * 997; i < 16 * 997; ++i) {
        const double light = std::min(std::exp2(i / 997.0), 65504.0);
        const double error =
            std::abs(from_table(nodes, light) - GetParam()->apply({light, light, light}).g);
        if (error > worst) {
            worst = error;
            at = light;
        }
    }
    // 1/8 of the second derivative of a power of 1/2.4 or 1/2.2 over an octave's 1/64.
    EXPECT_LE(worst, 2e-5) << at;
    EXPECT_LE(std::abs(from_table(nodes, 0) - GetParam()->apply({0, 0, 0}).g), 2e-5);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryTonemap, testing::ValuesIn([] {
                             std::vector<const Tonemap*> rows;
                             for (const Tonemap& row : tonemaps()) {
                                 rows.push_back(&row);
                             }
                             return rows;
                         }()),
                         [](const auto& row) { return support::test_name(row.param->name); });

TEST(Tonemaps, hit_published_values) {
    EXPECT_NEAR(srgb_decode(tonemap_named("reinhard")->apply({1, 1, 1}).g), 0.5, 1e-12);
    // Piccolo's white point: 11.2 / 4.5 maps to 1.
    EXPECT_NEAR(tonemap_named("uncharted2")->apply({11.2 / 4.5, 0, 0}).r, 1, 1e-12);
    // Narkowicz reaches 0.8 of the display's light at 1.
    EXPECT_NEAR(srgb_decode(tonemap_named("aces-narkowicz")->apply({1, 1, 1}).g), 0.8038, 1e-4);
    // Neutral keeps what lies between its toe and its shoulder but for the 4 % of Fresnel.
    EXPECT_NEAR(srgb_decode(tonemap_named("khronos-neutral")->apply({0.5, 0.5, 0.5}).g), 0.46,
                1e-12);
    // The sigmoid of AgX passes through its pivot, 0.18 of light, at half of the display's code.
    EXPECT_NEAR(tonemap_named("agx")->apply({0.18, 0.18, 0.18}).g, 0.5, 0.005);
}

} // namespace
} // namespace preview
