#include "lutlib/match/flat_means.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lutlib {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

bool is_there(const FlatMeans& means, int x, int y) {
    return std::isfinite(means.before.at(x, y).g) && std::isfinite(means.after.at(x, y).g);
}

// Dark on the left of an edge and bright on the right of it.
Picture edge(int width, int height, int at) {
    Picture out{width, height, {}};
    for (int i = 0; i < width * height; ++i) {
        const float value = i % width < at ? 0.25F : 0.75F;
        out.pixels.push_back({value, value, value});
    }
    return out;
}

TEST(FlatMeans, take_noise_away_and_leave_edges_out) {
    const Picture before = edge(40, 20, 8);
    Picture after = before;
    for (int i = 0; i < 40 * 20; ++i) {
        after.pixels[static_cast<std::size_t>(i)].g += (i + i / 40) % 2 ? 0.05F : -0.05F;
    }
    const FlatMeans means = flat_means(before, after);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 40; ++x) {
            // Two pixels to either side reach over the edge.
            const bool is_near = x >= 6 && x < 10;
            ASSERT_EQ(is_there(means, x, y), !is_near) << x << ' ' << y;
            if (!is_near) {
                EXPECT_FLOAT_EQ(means.before.at(x, y).g, before.at(x, y).g);
                // One of 25 has no partner of the other sign; of the 9 in a corner likewise.
                EXPECT_NEAR(means.after.at(x, y).g, before.at(x, y).g, 0.05 / 9 + 1e-6);
            }
        }
    }
}

TEST(FlatMeans, take_the_flatter_half_of_a_picture_that_is_nowhere_flat) {
    Picture busy{64, 64, {}};
    std::uint32_t state = 1;
    for (int i = 0; i < 64 * 64; ++i) {
        state = state * 1664525 + 1013904223;
        const float value = static_cast<float>(state >> 8) / (1 << 24);
        busy.pixels.push_back({value, value, value});
    }
    const FlatMeans means = flat_means(busy, busy);
    int there = 0;
    for (int i = 0; i < 64 * 64; ++i) {
        there += is_there(means, i % 64, i / 64) ? 1 : 0;
    }
    EXPECT_NEAR(there, 64 * 64 / 2, 2);
}

TEST(FlatMeans, spread_nothing_that_is_no_number_beyond_its_neighbours) {
    Picture before = edge(20, 20, 20);
    before.at(10, 10) = {none, none, none};
    const FlatMeans means = flat_means(before, before);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 20; ++x) {
            EXPECT_EQ(is_there(means, x, y), std::abs(x - 10) > 2 || std::abs(y - 10) > 2);
        }
    }
}

} // namespace
} // namespace lutlib
