#include "lutlib/resample/resample.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/interpolation/tricubic.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/resample/combine.h"
#include "lutlib/resample/sample_lut.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lutlib {
namespace {

const ResamplingMethod& tetrahedral() {
    return *resampling_method_named("tetrahedral");
}

Lut cube_look(Lut3D cube) {
    Lut out;
    out.cube = std::move(cube);
    return out;
}

Lut3D sampled_smooth(int size, const Domain& domain) {
    return sample_cube(Transform::each([](RgbD c) {
                           return RgbD{std::sin(c.r + 0.3 * c.g), 0.5 * c.g * c.g + c.b,
                                       std::cos(c.b * 1.3 - c.r)};
                       }),
                       domain, size);
}

class EveryMethod : public testing::TestWithParam<ResamplingMethod> {};
INSTANTIATE_TEST_SUITE_P(Resample, EveryMethod,
                         testing::ValuesIn(resampling_methods().begin(),
                                           resampling_methods().end()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(EveryMethod, reads_nodes_exactly_and_clamps_to_the_domain) {
    Lut lut;
    lut.cube = sampled_smooth(5, {{-1, 0, 0.25F}, {1, 4, 0.5F}});
    const Lut3D& cube = *lut.cube;
    const Transform read = GetParam().transform_of(lut);
    for (int b = 0; b < 5; ++b) {
        for (int g = 0; g < 5; ++g) {
            for (int r = 0; r < 5; ++r) {
                const RgbD got = read(node_position(cube, r, g, b));
                // Positions round to double, and the steepest cell has slope 4.
                EXPECT_NEAR(got.r, cube.at(r, g, b).r, 1e-14);
                EXPECT_NEAR(got.g, cube.at(r, g, b).g, 1e-14);
                EXPECT_NEAR(got.b, cube.at(r, g, b).b, 1e-14);
            }
        }
    }
    EXPECT_EQ(read({NAN, -INFINITY, -9}), to_double(cube.at(0, 0, 0)));
    EXPECT_EQ(read({9, INFINITY, 9}), to_double(cube.at(4, 4, 4)));
}

TEST_P(EveryMethod, keeps_a_linear_look_exact_at_any_size_and_domain) {
    const Transform linear = Transform::each([](RgbD c) {
        return RgbD{0.5 * c.r + 0.25 * c.g, c.g - c.b, 0.125 + c.b};
    });
    const Lut look = cube_look(sample_cube(linear, {{-1, -1, -1}, {3, 3, 3}}, 9));
    for (const int size : {2, 7, 33}) {
        Sampling sampling;
        sampling.size = size;
        sampling.domain = Domain{{0, 0, 0}, {2, 2, 2}};
        const Lut out = resample(look, sampling, GetParam());
        EXPECT_EQ(out.domain(), *sampling.domain);
        for (const Rgb& in : samples_over(*sampling.domain, 5, 500)) {
            RgbD want = to_double(in);
            linear(std::span(&want, 1));
            const RgbD got = evaluate_exact(out, to_double(in));
            EXPECT_NEAR(got.r, want.r, 1e-6); // nodes are floats of magnitude 3
            EXPECT_NEAR(got.g, want.g, 1e-6);
            EXPECT_NEAR(got.b, want.b, 1e-6);
        }
    }
}

TEST_P(EveryMethod, gives_a_look_back_when_nothing_is_asked_for) {
    Lut look = cube_look(sampled_smooth(6, {{0, 0, 0}, {2, 2, 2}}));
    look.shaper = Lut1D{{{-1, 0, 0}, {7, 8, 9}}, {{0, 0, 0}, {.5F, 1.5F, .1F}, {2, 1, 2}}};
    const Lut same = resample(look, {}, GetParam());
    EXPECT_EQ(same.shaper, look.shaper);
    for (std::size_t i = 0; i < look.cube->nodes.size(); ++i) {
        EXPECT_NEAR(same.cube->nodes[i].r, look.cube->nodes[i].r, 1e-6);
        EXPECT_NEAR(same.cube->nodes[i].g, look.cube->nodes[i].g, 1e-6);
    }
}

TEST(Tricubic, is_exact_for_quadratics_and_much_nearer_to_a_smooth_look) {
    const Transform quadratic = Transform::each([](RgbD c) {
        return RgbD{c.r * c.r - c.g, c.g * c.b, c.b * c.b + c.r};
    });
    const Lut3D cube = sample_cube(quadratic, {{-2, -2, -2}, {2, 2, 2}}, 9);
    for (const Rgb& in : samples_over({{-1.5F, -1.5F, -1.5F}, {1.5F, 1.5F, 1.5F}}, 4, 1000)) {
        RgbD want = to_double(in);
        quadratic(std::span(&want, 1));
        const RgbD got = tricubic(cube, to_double(in));
        EXPECT_NEAR(got.r, want.r, 2e-6); // nodes are floats of magnitude 6
        EXPECT_NEAR(got.g, want.g, 2e-6);
        EXPECT_NEAR(got.b, want.b, 2e-6);
    }
    const Lut coarse = cube_look(sampled_smooth(17, {}));
    const Lut fine = cube_look(sampled_smooth(65, {}));
    const auto inputs = samples_over({}, 17, 20000);
    const Transform truth = resampling_method_named("tricubic")->transform_of(fine);
    const auto error = [&](const char* method) {
        return compare(resampling_method_named(method)->transform_of(coarse), truth, inputs, srgb())
            .absolute.mean;
    };
    EXPECT_LT(error("tricubic"), 0.05 * error("tetrahedral"));
    EXPECT_LT(error("tricubic"), 0.05 * error("trilinear"));
}

TEST(Resample, puts_an_encodings_curve_before_the_cube) {
    const Lut look = cube_look(sampled_smooth(33, {{0, 0, 0}, {8, 8, 8}}));
    Sampling sampling;
    sampling.shaper = "logc3";
    sampling.input = require_encoding("linear");
    sampling.size = 65;
    const Lut out = resample(look, sampling, tetrahedral());
    ASSERT_TRUE(out.shaper);
    EXPECT_EQ(out.domain(), look.domain());
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(out.shaper->entries.front()[c], 0);
        EXPECT_EQ(out.shaper->entries.back()[c], 1);
    }
    const RgbD dark{0.01, 0.02, 0.03};
    EXPECT_NEAR(evaluate_exact(out, dark).r, evaluate_exact(look, dark).r, 1e-3);
}

TEST(Resample, refuses_what_cannot_be) {
    const Lut look = cube_look(identity_cube(5));
    const auto with = [&](std::optional<int> size, const char* shaper) {
        Sampling sampling;
        sampling.size = size;
        sampling.shaper = shaper;
        return resample(look, sampling, tetrahedral());
    };
    EXPECT_THROW(with(1, ""), Error);
    EXPECT_THROW(with(1000, ""), Error);
    EXPECT_THROW(with({}, "base"), Error);
    EXPECT_THROW(with({}, "nonsense"), Error);
}

TEST(Compose, applies_the_first_look_first_and_keeps_its_domain_and_table) {
    Lut a = cube_look(sampled([](RgbD c) { return RgbD{c.r * 0.5, c.g * 0.5, c.b * 0.5}; }, 9));
    a.shaper = Lut1D{{{0, 0, 0}, {2, 2, 2}}, {{0, 0, 0}, {1, 1, 1}}};
    const Lut b = cube_look(sampled([](RgbD c) { return RgbD{c.g, c.b, c.r + 0.25}; }, 17));
    const Lut both = compose({&a, &b}, {}, tetrahedral());
    EXPECT_EQ(both.shaper, a.shaper);
    EXPECT_EQ(both.cube->size, 17);
    for (const Rgb& in : samples_over(a.domain(), 5, 1000)) {
        const RgbD want = evaluate_exact(b, evaluate_exact(a, to_double(in)));
        const RgbD got = evaluate_exact(both, to_double(in));
        EXPECT_NEAR(got.r, want.r, 1e-6);
        EXPECT_NEAR(got.g, want.g, 1e-6);
        EXPECT_NEAR(got.b, want.b, 1e-6);
    }
}

TEST(Compose, with_the_identity_changes_nothing_and_counts_what_a_later_domain_clamps) {
    const Lut look = cube_look(sampled_smooth(9, {}));
    const Lut wide = cube_look(identity_cube(2, {{-4, -4, -4}, {4, 4, 4}}));
    const Lut narrow = cube_look(identity_cube(2));
    const Lut out = compose({&look, &wide}, {}, tetrahedral());
    for (std::size_t i = 0; i < out.cube->nodes.size(); ++i) {
        EXPECT_NEAR(out.cube->nodes[i].r, look.cube->nodes[i].r, 2e-6);
    }
    EXPECT_EQ(clamped_share({&look, &wide}, tetrahedral()), 0);
    const double share = clamped_share({&look, &narrow}, tetrahedral());
    EXPECT_GT(share, 0.05);
    EXPECT_LT(share, 0.95);
    // Of even colours an eighth has no channel above half, whatever part of nodes and greys does.
    const Lut half = cube_look(identity_cube(2, {{0, 0, 0}, {0.5F, 0.5F, 0.5F}}));
    const Lut same = cube_look(identity_cube(2));
    EXPECT_NEAR(clamped_share({&same, &half}, tetrahedral()), 7.0 / 8, 0.004);
}

TEST(Blend, is_each_look_at_its_end_and_the_mean_between) {
    const Lut a = cube_look(sampled_smooth(9, {}));
    const Lut b = cube_look(identity_cube(9));
    EXPECT_EQ(blend(a, b, 0, {}, tetrahedral()).cube->nodes, a.cube->nodes);
    EXPECT_EQ(blend(a, b, 1, {}, tetrahedral()).cube->nodes, b.cube->nodes);
    const Lut half = blend(a, b, 0.5, {}, tetrahedral());
    for (std::size_t i = 0; i < half.cube->nodes.size(); ++i) {
        EXPECT_NEAR(half.cube->nodes[i].g, (a.cube->nodes[i].g + b.cube->nodes[i].g) / 2, 1e-7);
    }
}

TEST(Blend, spans_both_domains_and_keeps_a_table_that_both_share) {
    Lut a = cube_look(sampled_smooth(5, {{0, 0, 0}, {4, 4, 4}}));
    Lut b = cube_look(sampled_smooth(9, {{-1, -1, -1}, {1, 1, 1}}));
    const Lut out = blend(a, b, 0.5, {}, tetrahedral());
    EXPECT_EQ(out.domain(), (Domain{{-1, -1, -1}, {4, 4, 4}}));
    EXPECT_EQ(out.cube->size, 9);
    b.cube->domain = a.cube->domain;
    a.shaper = b.shaper = Lut1D{{}, {{0, 0, 0}, {3, 3, 3}, {4, 4, 4}}};
    EXPECT_EQ(blend(a, b, 0.5, {}, tetrahedral()).shaper, a.shaper);
}

TEST(Compare, measures_a_known_difference_and_finds_where_it_is_worst) {
    const Transform identity;
    const Transform bump = Transform::each([](RgbD c) {
        const bool here =
            std::abs(c.r - 0.5) < 1e-6 && std::abs(c.g) < 1e-6 && std::abs(c.b - 1) < 1e-6;
        return here ? c + RgbD{0, 0.25, 0} : c;
    });
    const auto inputs = samples_over({}, 3, 1000);
    const Difference d = compare(identity, bump, inputs, srgb());
    EXPECT_DOUBLE_EQ(d.absolute.max, 0.25);
    EXPECT_EQ(d.worst.in, (Rgb{0.5F, 0, 1}));
    EXPECT_EQ(d.worst_to_eye.in, (Rgb{0.5F, 0, 1}));
    EXPECT_EQ(d.worst.b, (RgbD{0.5, 0.25, 1}));
    EXPECT_GT(d.delta_e_2000.max, 5);
    EXPECT_GT(d.delta_e_itp.max, 5);
    EXPECT_EQ(compare(identity, identity, inputs, srgb()).psnr, INFINITY);
    // One tenth everywhere: 20 dB.
    const Transform tenth = Transform::each([](RgbD c) { return c + RgbD{.1, .1, .1}; });
    EXPECT_NEAR(compare(identity, tenth, inputs, srgb()).psnr, 20, 1e-9);
}

TEST(Compare, counts_a_broken_transform_as_infinitely_wrong) {
    const Transform identity;
    const Transform broken = Transform::each([](RgbD c) { return RgbD{c.r, NAN, c.b}; });
    const Difference d = compare(identity, broken, samples_over({}, 2, 10), srgb());
    EXPECT_EQ(d.absolute.mean, INFINITY);
    EXPECT_EQ(d.delta_e_2000.max, INFINITY);
}

} // namespace
} // namespace lutlib
