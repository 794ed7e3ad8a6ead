// What is read back of a frame, and what is planted into it, on a device.
#include "preview/check/observe.h"
#include "preview/graph/interpose.h"
#include "preview/passes/copy.h"
#include "preview/passes/plant.h"
#include "preview/passes/resolve.h"
#include "tests/preview/graph/gpu_test.h"

#include <cmath>
#include <limits>

namespace preview {
namespace {

class ObserveTest : public GpuTest {
  protected:
    static constexpr ImageDesc desc{Format::rgba32f, 5, 3};
    /// A picture of 1, 2, 3... with these values in front.
    static gpu::Image picture(std::vector<float> texels) {
        while (texels.size() < 4UL * desc.width * desc.height) {
            texels.push_back(static_cast<float>(texels.size()));
        }
        return upload(desc, texels);
    }
};

TEST_F(ObserveTest, every_living_pass_is_seen_in_the_order_of_the_frame) {
    const gpu::Image image = picture({});
    Graph graph;
    const ImageHandle source = graph.import("picture", image, desc);
    const Resolved resolved = add_resolve(graph, source, {5, 3}, 2);
    (void)add_copy(graph, resolved.hdr, Format::rgba32f); // nobody reads it
    graph.present(add_copy(graph, resolved.hdr, Format::rgba8));
    graph.present(resolved.maximum);
    Executor executor(device());
    const std::vector<Observed> seen = observe(executor, graph);
    ASSERT_EQ(seen.size(), 3U); // hdr, its maximum, the copy in 8 bits
    EXPECT_EQ(seen[0].pass, "hdr resolve");
    EXPECT_EQ(seen[1].pass, "hdr resolve");
    EXPECT_EQ(seen[2].pass, "copy");
    EXPECT_EQ(left_by(seen, "hdr resolve")->values[4], 8);
    EXPECT_EQ(left_by(seen, "copy")->values[4], 1);
    EXPECT_EQ(left_by(seen, "none"), nullptr);
    for (const Observed& one : seen) {
        if (one.name == "hdr maximum") {
            EXPECT_EQ(one.values, std::vector<float>{2 * 58});
        }
        EXPECT_EQ(non_finite(one).all(), 0U);
    }
}

TEST_F(ObserveTest, nan_and_infinity_are_counted_by_texel) {
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                inf = std::numeric_limits<float>::infinity();
    const gpu::Image image = picture({nan, inf, 0, 1, inf, inf, 0, 1, -inf, 0, nan, 1});
    Graph graph;
    graph.present(add_copy(graph, graph.import("picture", image, desc), Format::rgba32f));
    Executor executor(device());
    const NonFinite bad = non_finite(observe(executor, graph).at(0));
    EXPECT_EQ(bad.nan, 2U);
    EXPECT_EQ(bad.infinite, 1U);
}

TEST_F(ObserveTest, a_value_is_planted_into_one_texel_and_all_else_is_copied) {
    const gpu::Image image = picture({});
    Graph graph;
    const ImageHandle source = graph.import("picture", image, desc);
    graph.present(add_copy(graph, source, Format::rgba32f));
    Executor executor(device());
    const std::vector<Observed> plain = observe(executor, graph);
    for (const float value : {-7.0F, std::numeric_limits<float>::quiet_NaN(), 0x1p-24F}) {
        const Graph changed = interposed(graph, source, [&](Graph& copy, ImageHandle from) {
            return add_plant(copy, from, {3, 1, value});
        });
        const std::vector<Observed> seen = observe(executor, changed);
        const std::vector<float>& before = left_by(plain, "copy")->values;
        const std::vector<float>& after = left_by(seen, "copy")->values;
        ASSERT_EQ(after.size(), before.size());
        for (std::size_t i = 0; i < before.size(); ++i) {
            const bool is_planted = i / 4 == 1 * desc.width + 3 && i % 4 < 3;
            const float wanted = is_planted ? value : before[i];
            EXPECT_TRUE(after[i] == wanted || (std::isnan(wanted) && std::isnan(after[i]))) << i;
        }
    }
}

} // namespace
} // namespace preview
