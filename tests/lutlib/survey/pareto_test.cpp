#include "lutlib/survey/pareto.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace lutlib {
namespace {

using Point = std::array<double, 3>;

bool dominates(const Point& a, const Point& b) {
    bool better = false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (a[i] > b[i]) {
            return false;
        }
        better = better || a[i] < b[i];
    }
    return better;
}

TEST(Pareto, names_a_dominator_from_the_front_exactly_where_there_is_one) {
    std::mt19937 random(1);
    std::vector<Point> points;
    for (int i = 0; i < 500; ++i) {
        // Small integers, so that ties and equal points occur.
        points.push_back({static_cast<double>(random() % 12), static_cast<double>(random() % 12),
                          static_cast<double>(random() % 12)});
    }
    const std::vector<std::size_t> by = dominators<3>(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool dominated = std::any_of(points.begin(), points.end(), [&](const Point& other) {
            return dominates(other, points[i]);
        });
        ASSERT_EQ(by[i] != not_dominated, dominated);
        if (dominated) {
            EXPECT_TRUE(dominates(points[by[i]], points[i]));
            EXPECT_EQ(by[by[i]], not_dominated);
        }
    }
}

TEST(Pareto, takes_a_cost_that_is_not_a_number_for_the_highest) {
    const std::vector<std::array<double, 2>> points{{1, 1}, {1, std::nan("")}, {0, std::nan("")}};
    EXPECT_EQ(dominators<2>(points), (std::vector<std::size_t>{not_dominated, 2, not_dominated}));
}

} // namespace
} // namespace lutlib
