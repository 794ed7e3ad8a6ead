#include "lutlib/bake/bake.h"

#include "lutlib/error.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/verify/verify.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <atomic>

namespace lutlib {
namespace {

class BakeFor : public testing::TestWithParam<Engine> {
  protected:
    const Engine& engine = GetParam();
};
INSTANTIATE_TEST_SUITE_P(Engines, BakeFor, testing::ValuesIn(engines().begin(), engines().end()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(BakeFor, rounds_every_node_to_nearest_in_every_depth_it_takes) {
    for (const int bits : engine.bits) {
        const auto look = test_looks()[3];
        const Bake baked = bake(look.transform(), engine, engine.default_size, bits);
        const Layout& layout = *layout_named(engine.layout);
        const int n = engine.default_size;
        for (int i = 0; i < n; ++i) {
            const Pixel p = layout.pixel(n, baked.picture.width, i, n - 1 - i, (3 * i) % n);
            const RgbD value = look.f({engine.node_input(i, n), engine.node_input(n - 1 - i, n),
                                       engine.node_input((3 * i) % n, n)});
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_EQ(baked.picture.at(p, c), std::lround(value[c] * ((1 << bits) - 1)));
            }
        }
        EXPECT_LE(baked.loss.max_rounding, 0.5 / ((1 << bits) - 1) + 1e-12);
        EXPECT_EQ(baked.loss.clamped_values, 0U);
    }
}

TEST_P(BakeFor, verifies_for_every_look) {
    const int n = engine.default_size;
    for (const TestLook& look : test_looks()) {
        const Bake baked = bake(look.transform(), engine, n, engine.default_bits);
        const Verification result = verify(baked.picture, engine, n, look.transform(), no_breaks(),
                                           srgb(), {.even = 1000, .grid = 4096, .between = 512});
        EXPECT_EQ(result.texels.wrong, 0U) << look.name;
        EXPECT_FALSE(result.diagnosis);
        EXPECT_LT(result.lookup.absolute.mean, 0.02) << look.name;
    }
}

TEST(Bake, asks_for_many_colors_at_once) {
    const Engine& engine = *engine_named("piccolo");
    std::atomic<std::size_t> calls = 0, colors = 0;
    bake(Transform::batch([&](std::span<RgbD> batch) {
             ++calls;
             colors += batch.size();
         }),
         engine, 16, 8);
    EXPECT_EQ(colors, 16U * 16 * 16);
    EXPECT_LE(calls, colors / 256);
}

TEST(Bake, counts_and_measures_what_it_clamps) {
    const Engine& engine = *engine_named("piccolo");
    const Bake baked = bake(Transform::each([](RgbD c) {
                                return RgbD{c.r * 2, c.g - 0.25, std::nan("")};
                            }),
                            engine, 16, 8);
    // Red above 1: 8 of 16 nodes; green below 0: 4 of 16; blue NaN: all.
    EXPECT_EQ(baked.loss.clamped_values, 16U * 16 * (8 + 4 + 16));
    EXPECT_DOUBLE_EQ(baked.loss.most_clamped, 1.0);
    EXPECT_EQ(baked.picture.at({0, 0}, 2), 0);
}

TEST(Bake, refuses_what_the_engine_does_not_take) {
    const Transform same;
    EXPECT_THROW(bake(same, *engine_named("unreal"), 32, 8), UsageError);
    EXPECT_THROW(bake(same, *engine_named("piccolo"), 16, 16), UsageError);
    EXPECT_THROW(bake(same, *engine_named("hald"), 33, 8), UsageError);
    EXPECT_THROW(bake(same, *engine_named("piccolo"), 1, 8), Error);
}

TEST(Samples, hold_the_corners_the_lattice_and_are_all_inside) {
    const std::vector<Rgb> all = sample_colors(5, {.neutral = 11, .random = 100});
    EXPECT_EQ(all.size(), 8U + 11 + 125 + 64 + 100);
    EXPECT_EQ(all[0], (Rgb{0, 0, 0}));
    EXPECT_EQ(all[7], (Rgb{1, 1, 1}));
    for (const Rgb& c : all) {
        EXPECT_EQ(saturate(c), c);
    }
}

TEST(ErrorStats, take_percentiles_of_absolute_values) {
    std::vector<double> errors;
    for (int i = 1; i <= 100; ++i) {
        errors.push_back(i % 2 ? i : -i);
    }
    const ErrorStats s = error_stats(errors);
    EXPECT_EQ(s.max, 100);
    EXPECT_EQ(s.p99, 99);
    EXPECT_EQ(s.p95, 95);
    EXPECT_DOUBLE_EQ(s.mean, 50.5);
    EXPECT_EQ(s.worst, 99U);
    EXPECT_TRUE(std::isinf(error_stats({0, std::nan("")}).max));
    EXPECT_EQ(error_stats({}).max, 0);
}

} // namespace
} // namespace lutlib
