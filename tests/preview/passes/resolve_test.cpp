// The HDR resolve on a device.
#include "preview/passes/resolve.h"
#include "tests/preview/passes/lit_fixture.h"

namespace preview {
namespace {

class ResolveTest : public GpuTest {
  protected:
    struct Result {
        std::vector<float> texels;
        float maximum = 0;
    };
    Result resolve(const ImageDesc& desc, const std::vector<float>& texels, Size target,
                   float exposure) {
        const gpu::Image image = upload(desc, texels);
        Graph graph;
        const Resolved out =
            add_resolve(graph, graph.import("source", image, desc), target, exposure);
        graph.present(out.hdr);
        graph.present(out.maximum);
        Executor executor(device());
        executor.render(graph);
        Result result;
        result.texels = floats_of(as<std::uint16_t>(executor.read_image(out.hdr)));
        result.maximum = as<float>(executor.read_buffer(out.maximum)).front();
        return result;
    }
};

TEST_F(ResolveTest, everything_becomes_finite_and_the_maximum_is_exact) {
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> texels{nan, inf, -inf, 1,   -1, 0, 1e30F, 1, 0.5F, 1, 2, nan,
                                    4,   8,   -nan, inf, 3,  1, 1,     1, 7,    0, 0, 0};
    const Result result = resolve({Format::rgba32f, 3, 2}, texels, {3, 2}, 2);
    const std::vector<float> expected{0, 65504, 0, 1, 0, 0, 65504, 1, 1,  2, 4, 1,
                                      8, 16,    0, 1, 6, 2, 2,     1, 14, 0, 0, 1};
    EXPECT_EQ(result.texels, expected);
    EXPECT_EQ(result.maximum, 65504);
    EXPECT_EQ(resolve({Format::rgba32f, 1, 1}, {0.25F, 0.125F, 0, 1}, {1, 1}, 1).maximum, 0.25F);
    EXPECT_EQ(resolve({Format::rgba32f, 1, 1}, {0, -4, 0, 1}, {1, 1}, 1).maximum, 0);
}

TEST_F(ResolveTest, another_size_keeps_the_mean_and_ignores_what_is_not_finite) {
    const ImageDesc desc{Format::rgba32f, 12, 9};
    std::vector<float> texels;
    double mean = 0;
    for (std::uint32_t index = 0; index < desc.width * desc.height; ++index) {
        const auto value = static_cast<float>(index % 7);
        mean += static_cast<double>(value) / (desc.width * desc.height);
        texels.insert(texels.end(), {value, value, value, 1});
    }
    for (const Size target : {Size{4, 3}, Size{24, 18}, Size{6, 5}}) {
        const Result result = resolve(desc, texels, target, 1);
        double found = 0;
        for (std::size_t at = 0; at < result.texels.size(); at += 4) {
            found += static_cast<double>(result.texels[at]) / (target.width * target.height);
        }
        // Texels are rounded to halves, and where it is enlarged the border repeats.
        EXPECT_NEAR(found, mean, 0.05) << target.width;
    }
    texels[0] = std::numeric_limits<float>::quiet_NaN();
    for (const float value : resolve(desc, texels, {4, 3}, 1).texels) {
        EXPECT_TRUE(std::isfinite(value));
    }
}

TEST_F(ResolveTest, a_picture_keeps_its_proportions_between_black_bars) {
    const ImageDesc desc{Format::rgba32f, 4, 2};
    const std::vector<float> texels(std::size_t{4} * 4 * 2, 3);
    struct Case {
        Size target, low, high; ///< the picture from low to before high
    };
    for (const auto& [target, low, high] :
         {Case{{4, 6}, {0, 2}, {4, 4}}, Case{{9, 2}, {2, 0}, {6, 2}}, Case{{2, 7}, {0, 3}, {2, 4}},
          Case{{1, 1}, {0, 0}, {1, 1}}}) {
        const Result result = resolve(desc, texels, target, 1);
        for (std::uint32_t y = 0; y < target.height; ++y) {
            for (std::uint32_t x = 0; x < target.width; ++x) {
                const bool inside =
                    x >= low.width && x < high.width && y >= low.height && y < high.height;
                EXPECT_EQ(result.texels[std::size_t{4} * (y * target.width + x)], inside ? 3 : 0)
                    << target.width << "x" << target.height << ": " << x << "," << y;
            }
        }
    }
}

} // namespace
} // namespace preview
