#include "lutlib/match/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lutlib {
namespace {

TEST(Coverage, counts_nodes_corners_and_greys) {
    constexpr int size = 9;
    std::vector<double> support(size * size * size);
    const auto at = [](int r, int g, int b) {
        return static_cast<std::size_t>(r + size * (g + size * b));
    };
    for (int i = 2; i <= 6; ++i) {
        support[at(i, i, i)] = 3;
    }
    support[at(8, 0, 0)] = 1;
    support[at(0, 8, 0)] = 0.001; // hardly a pixel
    const Coverage found = coverage_of(support, size);
    EXPECT_NEAR(found.supported, 6.0 / 729, 1e-12);
    ASSERT_TRUE(found.greys);
    EXPECT_EQ(*found.greys, (std::array<double, 2>{0.25, 0.75}));
    EXPECT_EQ(found.corners.front().name, "black");
    EXPECT_NEAR(found.corners[0].supported, 3.0 / 125, 1e-12);
    EXPECT_NEAR(found.corners[1].supported, 1.0 / 100, 1e-12);
    EXPECT_EQ(found.corners[2].supported, 0);
    EXPECT_NEAR(found.corners[7].supported, 2.0 / 64, 1e-12);
    // Against every supported node, one by one.
    std::size_t k = 0, near = 0;
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r, ++k) {
                int least = std::max({8 - r, g, b});
                for (int i = 2; i <= 6; ++i) {
                    least = std::min(least,
                                     std::max({std::abs(r - i), std::abs(g - i), std::abs(b - i)}));
                }
                ASSERT_EQ(found.steps[k], least) << r << ' ' << g << ' ' << b;
                near += least <= 2 ? 1U : 0U;
            }
        }
    }
    EXPECT_NEAR(found.near, static_cast<double>(near) / 729, 1e-12);
}

TEST(Coverage, of_nothing_is_nothing) {
    const Coverage found = coverage_of(std::vector<double>(8), 2);
    EXPECT_EQ(found.supported, 0);
    EXPECT_EQ(found.near, 0);
    EXPECT_FALSE(found.greys);
    EXPECT_EQ(found.steps.front(), std::numeric_limits<int>::max());
    const Coverage all = coverage_of(std::vector<double>(8, 1), 2);
    EXPECT_NEAR(all.supported, 1, 1e-12);
}

} // namespace
} // namespace lutlib
