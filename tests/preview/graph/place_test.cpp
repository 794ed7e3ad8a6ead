// Where images that live within a frame lie in its memory.
#include "preview/graph/plan.h"

#include <gtest/gtest.h>

#include <vector>

namespace preview {
namespace {

TEST(PlaceTest, those_that_never_meet_share_and_those_that_meet_never_overlap) {
    // A chain: each lives together with its neighbours only, so two rooms are enough.
    std::vector<Lifetime> lifetimes;
    std::vector<Extent> extents;
    for (std::uint32_t index = 0; index < 9; ++index) {
        lifetimes.push_back({index, index, index + 1});
        extents.push_back({index % 3 == 0 ? 1000U : 300U, 256});
    }
    const Placement placement = place(lifetimes, extents);
    std::uint64_t sum = 0;
    for (std::size_t a = 0; a < lifetimes.size(); ++a) {
        sum += extents[a].size;
        EXPECT_EQ(placement.offsets[a] % extents[a].alignment, 0U);
        EXPECT_LE(placement.offsets[a] + extents[a].size, placement.bytes);
        for (std::size_t b = 0; b < a; ++b) {
            const bool meet =
                lifetimes[a].first <= lifetimes[b].last && lifetimes[b].first <= lifetimes[a].last;
            const bool overlap = placement.offsets[a] < placement.offsets[b] + extents[b].size &&
                                 placement.offsets[b] < placement.offsets[a] + extents[a].size;
            EXPECT_FALSE(meet && overlap) << a << " and " << b;
        }
    }
    EXPECT_LE(placement.bytes * 2, sum);
}

TEST(PlaceTest, an_empty_pool_has_no_bytes) {
    EXPECT_EQ(place({}, {}).bytes, 0U);
}

} // namespace
} // namespace preview
