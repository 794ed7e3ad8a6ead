// The HDR resolve on a device.
#include "preview/passes/resolve.h"
#include "preview/reference/resolve.h"
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

TEST_F(ResolveTest, the_darkest_light_is_rounded_and_not_cut_off) {
    // Between denormals of half floats, 2^-24 apart: cut off, a quarter of this light would go.
    std::vector<float> texels;
    double mean = 0;
    for (int i = 0; i < 64 * 64; ++i) {
        const float value = static_cast<float>(i % 1021) / 256 * 0x1p-24F;
        mean += static_cast<double>(value) / (64 * 64);
        texels.insert(texels.end(), {value, value, value, 1});
    }
    const Result got = resolve({Format::rgba32f, 64, 64}, texels, {64, 64}, 1);
    double found = 0;
    for (std::size_t at = 0; at < got.texels.size(); at += 4) {
        found += static_cast<double>(got.texels[at]) / (64 * 64);
    }
    EXPECT_NEAR(found / mean, 1, 0.01);
}

TEST_F(ResolveTest, a_large_picture_keeps_its_mean_in_a_single_pixel) {
    // In one sum of floats what is added would be rounded to what the sum can hold. A software
    // device ends the loops of an invocation after 65535 turns, fewer than these texels.
    std::vector<float> texels;
    double mean = 0;
    constexpr int side = 600;
    for (int i = 0; i < side * side; ++i) {
        const float value = i < 240 ? 60000.0F : 0.3F;
        mean += static_cast<double>(value) / (side * side);
        texels.insert(texels.end(), {value, 0.3F, 0, 1});
    }
    const Result got = resolve({Format::rgba32f, side, side}, texels, {1, 1}, 1);
    EXPECT_NEAR(static_cast<double>(got.texels[0]) / mean, 1, 5.1e-4);
    EXPECT_NEAR(static_cast<double>(got.texels[1]) / 0.3, 1, 5.1e-4);
}

TEST_F(ResolveTest, equals_its_twin_where_a_pixel_covers_more_texels_than_loops_have_turns) {
    constexpr std::uint32_t width = 1021, height = 577;
    reference::Image light(width, height);
    std::vector<float> texels;
    for (int y = 0; y < light.height; ++y) {
        for (int x = 0; x < light.width; ++x) {
            // The lower end of each pixel is the brightest: it must not be missing.
            const auto value = static_cast<float>(y % 289 > 250 ? 40 + x % 7 : x % 3);
            light.at(x, y) = {static_cast<double>(value), static_cast<double>(x) / 512, -1};
            texels.insert(texels.end(), {value, static_cast<float>(x) / 512, -1, 1});
        }
    }
    for (const Size target : {Size{3, 2}, Size{2, 9}, Size{1, 1}}) {
        const Size inner = fitted({width, height}, target);
        const auto at = [](std::uint32_t side) { return static_cast<int>(side); };
        const reference::Image wanted = reference::resolved(
            light, 1.5, at(target.width), at(target.height),
            {at(target.width - inner.width) / 2, at(target.height - inner.height) / 2,
             at(inner.width), at(inner.height)});
        const Result got = resolve({Format::rgba32f, width, height}, texels, target, 1.5F);
        float largest = 0;
        for (std::size_t i = 0; i < wanted.pixels.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                // A rounding to half floats.
                EXPECT_NEAR(static_cast<double>(got.texels[4 * i + c]), wanted.pixels[i][c],
                            wanted.pixels[i][c] * 0x1p-10 + 0x1p-24)
                    << target.width << "x" << target.height << ": " << i;
                largest = std::max(largest, got.texels[4 * i + c]);
            }
        }
        EXPECT_EQ(got.maximum, largest) << target.width << "x" << target.height;
    }
}

TEST_F(ResolveTest, a_bright_texel_does_not_shine_beyond_its_own_pixel) {
    std::vector<float> texels(std::size_t{4} * 644 * 8, 0);
    for (std::size_t y = 0; y < 8; ++y) {
        texels[4 * (644 * y + 321)] = 65504; // the last of the left half
    }
    const Result got = resolve({Format::rgba32f, 644, 8}, texels, {80, 1}, 1);
    EXPECT_GT(got.texels[std::size_t{4} * 39], 8000);
    EXPECT_EQ(got.texels[std::size_t{4} * 40], 0);
}

TEST_F(ResolveTest, equals_its_twin_in_double_at_any_size) {
    reference::Image light(13, 7);
    std::vector<float> texels;
    for (int y = 0; y < light.height; ++y) {
        for (int x = 0; x < light.width; ++x) {
            const float value = x == 5 && y == 3 ? 60000.0F : static_cast<float>(x * y % 11) / 8;
            light.at(x, y) = {static_cast<double>(value), static_cast<double>(x) / 16, -1};
            texels.insert(texels.end(), {value, static_cast<float>(x) / 16, -1, 1});
        }
    }
    const double exposure = 1.5;
    for (const Size target : {Size{13, 7}, Size{4, 3}, Size{40, 9}, Size{1, 1}, Size{5, 31}}) {
        const Size inner = fitted({13, 7}, target);
        const auto at = [](std::uint32_t side) { return static_cast<int>(side); };
        const reference::Image wanted = reference::resolved(
            light, exposure, at(target.width), at(target.height),
            {at(target.width - inner.width) / 2, at(target.height - inner.height) / 2,
             at(inner.width), at(inner.height)});
        const Result got = resolve({Format::rgba32f, 13, 7}, texels, target, 1.5F);
        for (std::size_t i = 0; i < wanted.pixels.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                // A rounding to half floats.
                EXPECT_NEAR(static_cast<double>(got.texels[4 * i + c]), wanted.pixels[i][c],
                            wanted.pixels[i][c] * 0x1p-10 + 0x1p-24)
                    << target.width << "x" << target.height << ": " << i;
            }
        }
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
