#include "lutlib/color/difference_all.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace lutlib {
namespace {

struct Pair {
    Lab a, b;
    double difference;
};

// Sharma, Wu, Dalal 2005, table 1.
constexpr Pair published[] = {
    {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
    {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
    {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
    {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000},
    {{50, -1.1848, -84.8006}, {50, 0, -82.7485}, 1.0000},
    {{50, -0.9009, -85.5211}, {50, 0, -82.7485}, 1.0000},
    {{50, 0, 0}, {50, -1, 2}, 2.3669},
    {{50, -1, 2}, {50, 0, 0}, 2.3669},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0009}, 7.1792},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0010}, 7.1792},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0011}, 7.2195},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0012}, 7.2195},
    {{50, -0.0010, 2.4900}, {50, 0.0009, -2.4900}, 4.8045},
    {{50, -0.0010, 2.4900}, {50, 0.0010, -2.4900}, 4.8045},
    {{50, -0.0010, 2.4900}, {50, 0.0011, -2.4900}, 4.7461},
    {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
    {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
    {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
    {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
    {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
    {{50, 2.5, 0}, {50, 3.1736, 0.5854}, 1.0000},
    {{50, 2.5, 0}, {50, 3.2972, 0}, 1.0000},
    {{50, 2.5, 0}, {50, 1.8634, 0.5757}, 1.0000},
    {{50, 2.5, 0}, {50, 3.2592, 0.3350}, 1.0000},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
    {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
};

TEST(DeltaE2000, gives_every_published_value_in_both_directions) {
    static_assert(std::size(published) == 34);
    for (const Pair& row : published) {
        // The table is printed to four decimals.
        EXPECT_NEAR(delta_e_2000(row.a, row.b), row.difference, 5.1e-5);
        EXPECT_NEAR(delta_e_2000(row.b, row.a), row.difference, 5.1e-5);
    }
}

TEST(DeltaE2000, of_black_and_white_is_100_and_of_equal_colors_zero) {
    EXPECT_NEAR(delta_e_2000(RgbD{0, 0, 0}, RgbD{1, 1, 1}), 100, 1e-9);
    for (const RgbD c : {RgbD{0, 0, 0}, RgbD{.2, .9, .4}, RgbD{-.3, 7, 1}, RgbD{1e30, 0, 1}}) {
        EXPECT_EQ(delta_e_2000(c, c), 0);
        EXPECT_EQ(delta_e_itp(c, c), 0);
    }
}

TEST(DifferenceMetrics, are_infinite_when_a_channel_is_not_finite) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    const RgbD grey{.5, .5, .5};
    for (const RgbD broken : {RgbD{nan, 0, 0}, RgbD{0, inf, 0}, RgbD{0, 0, -inf}}) {
        EXPECT_EQ(delta_e_2000(broken, grey), inf);
        EXPECT_EQ(delta_e_2000(grey, broken), inf);
        EXPECT_EQ(delta_e_itp(broken, grey), inf);
        EXPECT_EQ(delta_e_itp_nits(grey, broken), inf);
        EXPECT_EQ(delta_e_2000(Lab{broken.r, broken.g, broken.b}, Lab{}), inf);
    }
}

TEST(DifferenceMetrics, are_finite_on_the_largest_finite_colors) {
    for (const double huge : {1e30, 3.4e38, -3.4e38}) {
        EXPECT_TRUE(std::isfinite(delta_e_2000(RgbD{huge, 0, 1}, RgbD{0, -huge, huge})));
        EXPECT_TRUE(std::isfinite(delta_e_itp(RgbD{huge, 0, 1}, RgbD{0, -huge, huge})));
    }
}

TEST(Lab, of_srgb_agrees_with_published_values) {
    // Lindbloom's colour calculator and CSS Color 4 agree on these to the digits given, up to
    // their rounding of the D65 white.
    const Lab red = lab_from_srgb({1, 0, 0});
    EXPECT_NEAR(red.L, 53.24, 0.01);
    EXPECT_NEAR(red.a, 80.09, 0.02);
    EXPECT_NEAR(red.b, 67.20, 0.02);
    const Lab blue = lab_from_srgb({0, 0, 1});
    EXPECT_NEAR(blue.L, 32.30, 0.01);
    EXPECT_NEAR(blue.a, 79.19, 0.02);
    EXPECT_NEAR(blue.b, -107.86, 0.02);
}

TEST(Lab, of_neutrals_has_no_chroma) {
    for (int code = 0; code <= 255; ++code) {
        const double v = code / 255.0;
        const Lab lab = lab_from_srgb({v, v, v});
        EXPECT_NEAR(lab.a, 0, 1e-12);
        EXPECT_NEAR(lab.b, 0, 1e-12);
    }
}

TEST(DeltaEItp, of_neutrals_is_720_times_the_difference_of_their_pq_codes) {
    // On the neutral axis T and P vanish and I is the PQ code: 100 cd/m2 .508078, 10 cd/m2 .299699
    // (ITU-R BT.2408 prints 51 % and 30 %).
    const double d = delta_e_itp_nits({100, 100, 100}, {10, 10, 10});
    EXPECT_NEAR(d, 720 * (0.508078 - 0.299699), 720 * 1e-6);
}

// Where the formula itself jumps: hues opposite to each other, and a mean hue at 0 degrees.
bool jumps(const Lab& p, const Lab& q) {
    const double dot = p.a * q.a + p.b * q.b, cross = p.a * q.b - p.b * q.a;
    const bool opposite = dot < 0 && std::abs(cross) < 1e-3 * -dot;
    const double across = std::abs(p.b * std::hypot(q.a, q.b) + q.b * std::hypot(p.a, p.b));
    return opposite || across < 1e-6 * std::hypot(p.a, p.b) * std::hypot(q.a, q.b);
}

class ColorCounts : public testing::TestWithParam<std::size_t> {};
// Around the lengths of vectors, and beyond one piece.
INSTANTIATE_TEST_SUITE_P(ManyColors, ColorCounts, testing::Values(0, 1, 2, 3, 7, 8, 9, 129, 5000));

TEST_P(ColorCounts, differ_as_much_as_one_pair_at_a_time) {
    const std::size_t count = GetParam();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> channel(-0.2, 1.2), near(-1e-3, 1e-3);
    std::vector<RgbD> a(count), b(count);
    for (std::size_t i = 0; i < count; ++i) {
        a[i] = {channel(random), channel(random), channel(random)};
        // Far apart, near, neutral against coloured, both neutral, equal.
        b[i] = i % 5 == 0   ? RgbD{channel(random), channel(random), channel(random)}
               : i % 5 == 1 ? a[i] + RgbD{near(random), near(random), near(random)}
               : i % 5 == 2 ? RgbD{a[i].g, a[i].g, a[i].g}
                            : a[i];
        if (i % 5 == 3) {
            a[i] = {a[i].r, a[i].r, a[i].r};
            b[i] = 0.5 * a[i];
        }
    }
    std::vector<Lab> lab_a(count), lab_b(count);
    lab_from_linear_all(a, lab_a);
    lab_from_linear_all(b, lab_b);
    std::vector<double> e_2000(count), e_itp(count);
    delta_e_2000_all(lab_a, lab_b, e_2000);
    delta_e_itp_nits_all(a, b, e_itp);
    for (std::size_t i = 0; i < count; ++i) {
        const Lab one = lab_from_linear(a[i]);
        for (const double d : {one.L - lab_a[i].L, one.a - lab_a[i].a, one.b - lab_a[i].b}) {
            EXPECT_NEAR(d, 0, 1e-10);
        }
        EXPECT_NEAR(e_itp[i], delta_e_itp_nits(a[i], b[i]), 1e-9);
        if (!jumps(lab_a[i], lab_b[i])) {
            EXPECT_NEAR(e_2000[i], delta_e_2000(lab_a[i], lab_b[i]), 1e-9)
                << lab_a[i].L << " " << lab_a[i].a << " " << lab_a[i].b << " against " << lab_b[i].L
                << " " << lab_b[i].a << " " << lab_b[i].b;
        }
        if (a[i] == b[i]) {
            EXPECT_EQ(e_2000[i], 0);
            EXPECT_EQ(e_itp[i], 0);
        }
    }
}

TEST(ManyColors, give_every_published_value) {
    std::vector<Lab> a, b;
    for (const Pair& row : published) {
        a.push_back(row.a);
        b.push_back(row.b);
    }
    std::vector<double> out(a.size());
    delta_e_2000_all(a, b, out);
    for (std::size_t i = 0; i < out.size(); ++i) {
        EXPECT_NEAR(out[i], published[i].difference, 5.1e-5);
    }
}

TEST(ManyColors, that_are_not_finite_are_infinitely_far_and_huge_ones_finitely) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    for (const double x : {nan, inf, -inf, 1e30, 3e90, -3e90}) {
        const RgbD colors[] = {{.5, .5, .5}, {x, 0, 0}, {0, x, 0}, {0, 0, x}, {x, x, x}};
        const RgbD greys[] = {{.5, .5, .5}, {.5, .5, .5}, {.1, .2, .3}, {0, 0, 0}, {1, 1, 1}};
        std::vector<Lab> a(5), b(5);
        std::vector<double> e_2000(5), e_itp(5);
        lab_from_linear_all(colors, a);
        lab_from_linear_all(greys, b);
        delta_e_2000_all(a, b, e_2000);
        delta_e_itp_nits_all(colors, greys, e_itp);
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_EQ(std::isfinite(e_2000[i]), i == 0 || std::isfinite(x)) << x;
            EXPECT_EQ(std::isfinite(e_itp[i]), i == 0 || std::isfinite(x)) << x;
        }
        EXPECT_EQ(e_2000[0], 0);
    }
}

} // namespace
} // namespace lutlib
