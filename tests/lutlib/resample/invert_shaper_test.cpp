// The inverse of a look with a 1D table before its cube, and one that gets such a table.
#include "lutlib/resample/invert.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/resample/invert_shaper.h"
#include "tests/lutlib/resample/inverse_looks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

TEST(Invert, puts_its_nodes_where_a_shaper_says) {
    // Light of 0..16 to codes; the inverse of the inverse is fed light.
    const auto steep = [](RgbD c) {
        const auto code = [](double v) { return std::log2(1 + 100 * v) / std::log2(1 + 100.0); };
        return RgbD{code(c.r), code(c.g), code(c.b)};
    };
    const auto linear = [](RgbD c) {
        const auto light = [](double v) { return (std::exp2(v * std::log2(1 + 100.0)) - 1) / 100; };
        return RgbD{light(c.r), light(c.g), light(c.b)};
    };
    const Lut look = cube_look(sampled(linear, 17));
    const auto error = [&](const std::string& shaper) {
        InvertOptions options;
        options.shaper = shaper;
        options.input = require_encoding("linear");
        const Lut inverse = invert(look, options).lut;
        double most = 0;
        for (double v = 0.001; v < 1; v += 0.001) {
            const double back = evaluate_exact(inverse, {v, v, v}).g;
            most = std::max(most, std::abs(back - steep({v, v, v}).g));
        }
        return most;
    };
    EXPECT_LT(error("srgb"), error("none") / 4);
    EXPECT_THROW(invert(look, {.shaper = "steep"}), Error);
}

TEST(OutputShaper, rises_from_0_to_1_and_most_where_outputs_crowd) {
    std::vector<RgbD> outputs;
    for (int i = 0; i < 1000; ++i) {
        const double x = i / 999.0;
        outputs.push_back({2 * std::sqrt(x), x, 2}); // crowds high, even, clipped at the end
    }
    const Lut1D table = output_shaper(outputs, {{0, 0, 0}, {2, 1, 2}}, 65);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(table.entries.front()[c], 0) << c;
        EXPECT_FLOAT_EQ(table.entries.back()[c], 1) << c;
        for (std::size_t i = 0; i + 1 < table.entries.size(); ++i) {
            EXPECT_LT(table.entries[i][c], table.entries[i + 1][c]) << c << ' ' << i;
        }
    }
    // The share below output y is y squared over 4: at the middle a quarter, and a fifth evenly.
    EXPECT_NEAR(table.entries[32].r, 0.2 * 0.5 + 0.8 * 0.25, 2e-3);
    EXPECT_NEAR(table.entries[32].g, 0.5, 2e-3);
    EXPECT_FLOAT_EQ(table.entries[16].b, 0.25F) << "clipped outputs crowd nowhere";
}

TEST(Invert, reads_a_1d_table_backwards) {
    Lut look = cube_look(sampled(gentle, 17));
    look.shaper = Lut1D{{{0, 0, 0}, {4, 4, 4}}, {}};
    for (int i = 0; i < 100; ++i) {
        const auto v = static_cast<float>(std::pow(i / 99.0, 0.5));
        look.shaper->entries.push_back({v, v, v});
    }
    const Inversion out = invert(look, {});
    const RgbD in{1.2, 0.9, 1.6};
    const RgbD back = evaluate_exact(out.lut, evaluate_exact(look, in));
    EXPECT_NEAR(back.r, in.r, 0.05); // the table's square is interpolated by the inverse's cube
    EXPECT_NEAR(back.g, in.g, 0.05);
    Lut curve;
    curve.shaper = look.shaper;
    InvertOptions options;
    options.size = 65;
    EXPECT_NEAR(evaluate_exact(invert(curve, options).lut, {.5, .5, .5}).r, 1.0, 1e-3);
}

// The table is x / 4, and red turns back at its 0.25.
TEST(Invert, measures_folds_and_nearness_in_inputs_where_there_is_a_1d_table) {
    Lut look = cube_look(sampled(
        [](RgbD c) {
            return RgbD{c.r >= 0.25 ? c.r : 0.5 - c.r, c.g, c.b};
        },
        17));
    look.shaper = Lut1D{{{0, 0, 0}, {4, 4, 4}}, {{0, 0, 0}, {1, 1, 1}}};
    const Inversion out = invert(look, {});
    // 0.375 comes of 1.5 and of 0.5, which is nearer.
    EXPECT_NEAR(out.lut.cube->at(6, 0, 0).r, 0.5, 1e-6);
    EXPECT_NEAR(out.folded.extent, 2, 1e-6);
}

TEST(Invert, counts_what_only_inputs_beyond_the_1d_table_would_give) {
    Lut look = cube_look(identity_cube(17));
    look.shaper = Lut1D{{}, {{0, 0, 0}, {.5F, 1, 1}}};
    const Inversion out = invert(look, {.outside = Outside::nearest});
    EXPECT_EQ(out.out_of_gamut.count, 8U * 17 * 17);
    EXPECT_NEAR(out.out_of_gamut.extent, 0.5, 1e-6);
    EXPECT_NEAR(out.lut.cube->at(16, 0, 0).r, 1, 1e-6);
}

TEST(Invert, refuses_a_table_before_a_cube_that_is_flat_and_a_cube_that_is_too_large) {
    Lut look = cube_look(identity_cube(5));
    look.shaper = Lut1D{{}, {{0, 0, 0}, {.5F, .5F, .5F}, {.5F, .6F, .6F}, {1, 1, 1}}};
    EXPECT_THROW(invert(look, {}), Error);
    look.shaper.reset();
    look.cube = identity_cube(130);
    EXPECT_THROW(invert(look, {}), Error);
}

} // namespace
} // namespace lutlib
