#include "lutlib/survey/timing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>

namespace lutlib {
namespace {

std::vector<double> from_one_to(int n) {
    std::vector<double> out(static_cast<std::size_t>(n));
    std::iota(out.begin(), out.end(), 1.0);
    std::shuffle(out.begin(), out.end(), std::mt19937(1));
    return out;
}

TEST(Timing, has_the_ranks_of_published_tables_for_the_median_s_interval) {
    // Conover, "Practical Nonparametric Statistics", 1999, table A3, for p = 0.5 and 0.025 a tail.
    const struct {
        int runs;
        double low, high;
    } rows[] = {{6, 1, 6}, {9, 2, 8}, {15, 4, 12}, {20, 6, 15}, {25, 8, 18}};
    for (const auto& row : rows) {
        const Timing timing = timing_of(from_one_to(row.runs));
        EXPECT_EQ(timing.low, row.low) << row.runs;
        EXPECT_EQ(timing.high, row.high) << row.runs;
        EXPECT_EQ(timing.median, (row.runs + 1) / 2.0);
        EXPECT_EQ(timing.best, 1);
        EXPECT_EQ(timing.repetitions, row.runs);
    }
}

TEST(Timing, of_few_runs_spans_all_of_them) {
    const Timing three = timing_of({2, 1, 3});
    EXPECT_EQ(three.low, 1);
    EXPECT_EQ(three.high, 3);
    const Timing one = timing_of({5});
    EXPECT_EQ(one.low, 5);
    EXPECT_EQ(one.median, 5);
    EXPECT_EQ(one.high, 5);
}

TEST(Timing, takes_every_run_once_in_each_round) {
    std::string order;
    const std::vector<std::function<void()>> runs{[&] { order += 'a'; }, [&] { order += 'b'; }};
    double last = 0;
    const std::vector<Timing> timings =
        measure_interleaved(runs, 3, [&](double share) { last = share; });
    // Twice: once to warm the caches.
    EXPECT_EQ(order, "aabbaabbaabb");
    ASSERT_EQ(timings.size(), 2U);
    EXPECT_EQ(timings[1].repetitions, 3);
    EXPECT_EQ(last, 1);
}

} // namespace
} // namespace lutlib
