#include "lutlib/color/transfer.h"

#include <gtest/gtest.h>

#include <cmath>

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
