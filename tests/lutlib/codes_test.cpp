#include "lutlib/codes.h"

#include <gtest/gtest.h>

#include <limits>

namespace lutlib {
namespace {

class EveryDepth : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Bits, EveryDepth, testing::Values(1, 8, 10, 12, 16));

TEST_P(EveryDepth, every_code_is_the_code_of_its_value_in_double_and_in_float) {
    const CodeDepth depth{GetParam()};
    EXPECT_EQ(depth.maximum(), (1 << GetParam()) - 1);
    for (int code = 0; code <= depth.maximum(); ++code) {
        ASSERT_EQ(depth.code(depth.value(code)), code);
        ASSERT_EQ(depth.code(static_cast<float>(depth.value(code))), code);
    }
}

TEST_P(EveryDepth, codes_change_half_way_between_their_values) {
    const CodeDepth depth{GetParam()};
    for (int code = 0; code < depth.maximum(); ++code) {
        const double middle = (code + 0.5) / depth.maximum();
        ASSERT_EQ(depth.code(middle - 1e-12), code);
        ASSERT_EQ(depth.code(middle + 1e-12), code + 1);
        const int at_middle = depth.code(middle);
        ASSERT_TRUE(at_middle == code || at_middle == code + 1);
    }
}

TEST_P(EveryDepth, float_arithmetic_differs_only_beside_the_middle_between_two_codes) {
    const CodeDepth depth{GetParam()};
    for (int i = 0; i <= 1 << 20; ++i) {
        const float value = static_cast<float>(i) / (1 << 20);
        const double exact = static_cast<double>(value) * depth.maximum();
        const double from_middle = std::abs(exact - std::floor(exact) - 0.5);
        const int difference = depth.code(value) - depth.code(static_cast<double>(value));
        ASSERT_TRUE(difference == 0 || (std::abs(difference) == 1 && from_middle <= 1.0 / 256))
            << value;
    }
}

TEST_P(EveryDepth, holds_to_its_range_what_lies_outside_and_takes_nan_for_0) {
    const CodeDepth depth{GetParam()};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double value : {-1e-9, -1.0, -1e300, -infinity, std::nan("")}) {
        EXPECT_EQ(depth.code(value), 0) << value;
        EXPECT_EQ(depth.code(static_cast<float>(value)), 0) << value;
    }
    for (const double value : {1.0, 1.0 + 1e-9, 7.0, 1e300, infinity}) {
        EXPECT_EQ(depth.code(value), depth.maximum()) << value;
        EXPECT_EQ(depth.code(static_cast<float>(value)), depth.maximum()) << value;
    }
    EXPECT_EQ(depth.code(-0.0), 0);
    EXPECT_EQ(depth.code(std::numeric_limits<double>::denorm_min()), 0);
}

} // namespace
} // namespace lutlib
