// Numbers of pictures that are no light.
#include "preview/look/odd_numbers.h"

#include <gtest/gtest.h>

#include <limits>

namespace preview {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(OddNumbers, are_counted_by_pixel_and_become_finite) {
    std::vector<float> rgba{0.25F, 0,   1e6F, 1,    // nothing odd
                            nan,   nan, 2,    0.5F, // one pixel of NaN
                            nan,   inf, -1,   1,    // each once
                            -inf,  3,   4,    1,    //
                            1,     1,   1,    nan}; // no colour
    EXPECT_EQ(settle_odd_numbers(rgba),
              (OddPixels{.with_nan = 2, .with_infinity = 1, .with_negative = 2}));
    EXPECT_EQ(rgba, (std::vector<float>{0.25F, 0, 1e6F, 1, 0, 0, 2, 0.5F, 0, 65504, -1, 1, //
                                        0,     3, 4,    1, 1, 1, 1, 0}));
    EXPECT_EQ(settle_odd_numbers(rgba), (OddPixels{.with_negative = 1})) << "what is finite stays";
}

TEST(OddNumbers, are_told_a_sentence_each_where_there_are_some) {
    EXPECT_TRUE(told_of(OddPixels{}).empty());
    EXPECT_EQ(told_of({.with_nan = 1, .with_infinity = 2, .with_negative = 3}),
              (std::vector<std::string>{
                  "1 pixel holds NaN, which is taken for 0",
                  "2 pixels hold infinity, which is taken for 65504, the largest half float",
                  "3 pixels hold numbers below 0; what is still below 0 as it is shown is 0 "
                  "there"}));
}

} // namespace
} // namespace preview
