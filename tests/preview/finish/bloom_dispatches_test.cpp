// Which steps of a bloom one dispatch does, without a GPU.
#include "preview/finish/bloom_dispatches.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace preview {
namespace {

constexpr BloomExtent sizes[]{{1, 1},     {3, 2},       {64, 36},     {135, 67},    {4096, 3},
                              {640, 360}, {1920, 1080}, {2560, 1440}, {3840, 2160}, {7680, 4320}};

class EveryBloomDispatched : public testing::TestWithParam<const Bloom*> {
  protected:
    static BloomPlan plan_of(BloomExtent size) { return bloom_plan(*GetParam(), size, {}); }
};

bool reads(const BloomStep& step, int image) {
    return step.source == image || step.own == image;
}

TEST_P(EveryBloomDispatched, does_every_step_once_and_in_order) {
    for (const BloomExtent size : sizes) {
        const BloomPlan plan = plan_of(size);
        for (const bool fuses : {false, true}) {
            std::size_t next = 0;
            for (const BloomDispatch& dispatch : bloom_dispatches(plan, fuses)) {
                EXPECT_EQ(dispatch.first, next);
                EXPECT_EQ(dispatch.count > 1, dispatch.kind != BloomDispatch::Kind::step);
                EXPECT_TRUE(fuses || dispatch.count == 1);
                next += dispatch.count;
            }
            EXPECT_EQ(next, plan.steps.size());
        }
    }
}

TEST_P(EveryBloomDispatched, leaves_one_image_to_others) {
    for (const BloomExtent size : sizes) {
        const BloomPlan plan = plan_of(size);
        for (const BloomDispatch& dispatch : bloom_dispatches(plan)) {
            const std::size_t end = dispatch.first + dispatch.count;
            for (std::size_t i = dispatch.first; i + 1 < end; ++i) {
                const int image = plan.steps[i].target;
                EXPECT_NE(plan.last.image, image);
                for (std::size_t other = end; other < plan.steps.size(); ++other) {
                    EXPECT_FALSE(reads(plan.steps[other], image));
                }
            }
        }
    }
}

TEST_P(EveryBloomDispatched, keeps_what_will_be_read_in_the_memory_of_a_group) {
    for (const BloomExtent size : sizes) {
        const BloomPlan plan = plan_of(size);
        for (const BloomDispatch& dispatch : bloom_dispatches(plan)) {
            if (dispatch.kind != BloomDispatch::Kind::small) {
                continue;
            }
            ASSERT_EQ(dispatch.places.size() + 1, dispatch.count);
            // Who has written each texel, played through.
            std::vector<int> texels(BloomDispatch::group_texels, -1);
            const auto holds = [&](int image) {
                for (std::size_t i = 0; i < dispatch.places.size(); ++i) {
                    if (plan.steps[dispatch.first + i].target == image) {
                        const BloomExtent extent = plan.images[static_cast<std::size_t>(image)];
                        const auto begin = texels.begin() + dispatch.places[i];
                        return std::all_of(begin, begin + extent.width * extent.height,
                                           [&](int texel) { return texel == image; });
                    }
                }
                return image == dispatch.source;
            };
            for (std::size_t i = 0; i < dispatch.count; ++i) {
                const BloomStep& step = plan.steps[dispatch.first + i];
                EXPECT_FALSE(step.prefilter || step.karis);
                EXPECT_TRUE(holds(step.source));
                EXPECT_TRUE(step.own < 0 || holds(step.own));
                const BloomExtent extent = plan.images[static_cast<std::size_t>(step.target)];
                ASSERT_LE(extent.width * extent.height, BloomDispatch::group_texels);
                if (i < dispatch.places.size()) {
                    ASSERT_LE(dispatch.places[i] + extent.width * extent.height,
                              BloomDispatch::group_texels);
                    std::fill_n(texels.begin() + dispatch.places[i], extent.width * extent.height,
                                step.target);
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Table, EveryBloomDispatched, testing::ValuesIn([] {
                             std::vector<const Bloom*> rows;
                             for (const Bloom& row : blooms()) {
                                 rows.push_back(&row);
                             }
                             return rows;
                         }()),
                         [](const auto& row) { return support::test_name(row.param->name); });

TEST(BloomDispatches, of_the_glare_are_few) {
    for (const BloomExtent size : {BloomExtent{1920, 1080}, {3840, 2160}}) {
        const BloomPlan plan = bloom_plan(*bloom_named("glare"), size, {});
        EXPECT_EQ(plan.steps.size(), size.height == 1080 ? 15U : 16U);
        EXPECT_LE(bloom_dispatches(plan).size(), 6U);
    }
}

TEST(TexelWeights, sum_up_to_what_the_taps_do) {
    for (const float sigma : {0.05F, 0.7F, 1.5F, 3.2F, 14.0F}) {
        const std::vector<BloomTap> taps = gaussian_taps(sigma);
        const std::vector<float> weights = texel_weights(taps);
        EXPECT_LE(weights.size(), static_cast<std::size_t>(taps.back().x) + 2);
        const float sum =
            weights[0] + 2 * std::accumulate(weights.begin() + 1, weights.end(), 0.0F);
        EXPECT_NEAR(sum, 1, 1e-5);
        for (std::size_t i = 1; i < weights.size(); ++i) {
            EXPECT_LE(weights[i], weights[i - 1]) << sigma << ' ' << i;
        }
    }
}

} // namespace
} // namespace preview
