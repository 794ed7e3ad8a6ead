#include "lutlib/color/transfer.h"

#include "lutlib/color/encoding.h"
#include "lutlib/color/powers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace lutlib {
namespace {

struct Curve {
    const char* name;
    double (*decode)(double);
    double (*encode)(double);
    double lowest, highest; // codes of the range that the curve keeps
};

constexpr Curve curves[] = {
    {"srgb", srgb_decode, srgb_encode, -2, 4},
    {"gamma24", gamma24_decode, gamma24_encode, -2, 4},
    {"logc3", logc3_decode, logc3_encode, -1, 1.5},
    {"acescct", acescct_decode, acescct_encode, -1, 1.4679},
    {"pq", pq_decode, pq_encode, 0, 1},
};

class EveryTransfer : public testing::TestWithParam<Curve> {};
INSTANTIATE_TEST_SUITE_P(Transfer, EveryTransfer, testing::ValuesIn(curves),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(EveryTransfer, comes_back_to_the_code_it_decoded) {
    const Curve& c = GetParam();
    for (int i = 0; i <= 10000; ++i) {
        const double code = c.lowest + (c.highest - c.lowest) * i / 10000;
        // ARRI and IEC publish rounded constants, whose two segments meet within 2e-6; PQ loses
        // digits next to black, where its slope is infinite.
        ASSERT_NEAR(c.encode(c.decode(code)), code, 3e-6) << code;
    }
}

TEST_P(EveryTransfer, rises_over_the_range_that_it_keeps) {
    const Curve& c = GetParam();
    double before = c.decode(c.lowest);
    for (int i = 1; i <= 10000; ++i) {
        const double linear = c.decode(c.lowest + (c.highest - c.lowest) * i / 10000);
        ASSERT_GE(linear, before - 1e-6); // the same published constants
        before = linear;
    }
}

TEST_P(EveryTransfer, is_finite_for_every_finite_float) {
    for (const double x : {0.0, -0.0, 1e-40, -1e-40, 1e10, -1e10, 3.4e38, -3.4e38}) {
        EXPECT_TRUE(std::isfinite(GetParam().decode(x))) << x;
        EXPECT_TRUE(std::isfinite(GetParam().encode(x))) << x;
    }
}

class EveryEncoding : public testing::TestWithParam<Encoding> {};
INSTANTIATE_TEST_SUITE_P(Transfer, EveryEncoding,
                         testing::ValuesIn(encodings().begin(), encodings().end()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(EveryEncoding, is_the_same_on_many_colours_as_on_one) {
    std::vector<RgbD> in;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> near(-0.5, 1.5), exponent(-12, 38);
    for (int i = 0; i < 20001; ++i) {
        in.push_back({near(random), near(random), near(random)});
        const double huge = std::pow(10, exponent(random));
        in.push_back({huge, -huge, i % 2 ? 0.0 : -0.0});
    }
    for (const bool encode : {true, false}) {
        std::vector<RgbD> many = in;
        encode ? GetParam().encode_all(many) : GetParam().decode_all(many);
        const auto one = encode ? GetParam().encode : GetParam().decode;
        for (std::size_t i = 0; i < in.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double want = one(in[i][c]);
                // PQ raises to the power of 78.8 and back, which multiplies the rounding.
                ASSERT_NEAR(many[i][c], want, 1e-12 * (1 + std::abs(want))) << in[i][c];
            }
        }
    }
}

TEST(Powers, cube_root_is_exact_to_the_last_places_and_odd) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> exponent(-30, 38);
    std::vector<double> in{0, -0.0, 1, -1, 8, -27, 1e-300, 3.4e38};
    for (int i = 0; i < 10000; ++i) {
        in.push_back((i % 2 ? 1 : -1) * std::pow(10, exponent(random)));
    }
    std::vector<double> out = in;
    cube_root_all(out);
    for (std::size_t i = 0; i < in.size(); ++i) {
        ASSERT_NEAR(out[i], std::cbrt(in[i]), 1e-15 * std::abs(std::cbrt(in[i]))) << in[i];
    }
}

TEST(Transfer, gives_the_published_code_of_mid_grey) {
    EXPECT_NEAR(logc3_encode(0.18), 0.391007, 1e-6);    // ARRI: 400/1023 at every EI
    EXPECT_NEAR(acescct_encode(0.18), 0.4135884, 1e-7); // S-2016-001, table 1
    EXPECT_NEAR(srgb_encode(0.18), 0.4613561, 1e-7);
    EXPECT_NEAR(pq_encode(1.0), 0.5080784, 1e-7); // 100 cd/m2
    EXPECT_NEAR(pq_encode(100.0), 1.0, 1e-12);
    EXPECT_NEAR(gamma24_decode(0.5), 0.1894646, 1e-7);
}

} // namespace
} // namespace lutlib
