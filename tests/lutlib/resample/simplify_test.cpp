#include "lutlib/interpolation/interpolation.h"
#include "lutlib/resample/simplify.h"
#include "lutlib/survey/stiff_suite.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace lutlib {
namespace {

std::vector<std::string_view> names_of(const Simplified& simplified) {
    std::vector<std::string_view> out;
    for (const Omission& omission : simplified.omissions) {
        out.push_back(omission.name);
    }
    return out;
}

Lut1D straight_table(int size, const Domain& domain, Rgb low, Rgb high) {
    Lut1D out{domain, {}};
    for (int i = 0; i < size; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(size - 1);
        out.entries.push_back(low * (1 - t) + high * t);
    }
    return out;
}

// The bound is proved by looking at nodes; this looks everywhere else.
void expect_equal_within_bound(const Lut& lut, const Simplified& simplified, const char* what) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    double size = 1;
    for (const Rgb& node : lut.cube ? lut.cube->nodes : lut.shaper->entries) {
        size = std::max(size, largest_magnitude(to_double(node)));
    }
    for (int i = 0; i < 3000; ++i) {
        RgbD in;
        for (std::size_t c = 0; c < 3; ++c) {
            in[c] = std::lerp(static_cast<double>(lut.domain().min[c]),
                              static_cast<double>(lut.domain().max[c]), unit(random));
        }
        for (const auto how : {Interpolation::trilinear, Interpolation::tetrahedral}) {
            const RgbD d = evaluate_exact(lut, in, how) - evaluate_exact(simplified.lut, in, how);
            // Beside the bound only the oracle's own rounding in double.
            ASSERT_LE(largest_magnitude(d), simplified.bound + 1e-13 * size)
                << what << " at " << in.r << " " << in.g << " " << in.b;
        }
    }
}

class SimplifiedStiffLook : public testing::TestWithParam<StiffLook> {};
INSTANTIATE_TEST_SUITE_P(Suite, SimplifiedStiffLook,
                         testing::ValuesIn(stiff_suite().begin(), stiff_suite().end()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(SimplifiedStiffLook, is_equal_within_the_stated_bound_which_is_within_the_tolerance) {
    const Lut lut = GetParam().make();
    for (const double tolerance : {0.0, 1e-6, 1e-3, 0.05}) {
        const Simplified simplified = simplify(lut, {tolerance});
        EXPECT_LE(simplified.bound, tolerance);
        double sum = 0;
        for (const Omission& omission : simplified.omissions) {
            sum += omission.bound;
        }
        EXPECT_DOUBLE_EQ(simplified.bound, sum);
        expect_equal_within_bound(lut, simplified, GetParam().name.data());
        EXPECT_TRUE(simplify(simplified.lut, {0}).omissions.empty());
    }
}

TEST(Simplify, does_not_apply_an_identity) {
    for (const Domain& domain : {Domain{}, Domain{{-1, 0, 2}, {4, 1, 3}}}) {
        Lut lut;
        lut.cube = identity_cube(33, domain);
        const Simplified simplified = simplify(lut);
        EXPECT_FALSE(simplified.lut.cube || simplified.lut.shaper);
        EXPECT_EQ(names_of(simplified), std::vector<std::string_view>{"identity-cube"});
    }
}

TEST(Simplify, makes_a_1d_table_of_a_cube_whose_channels_do_not_mix) {
    const Lut lut = stiff_look_named("shoulder_8")->make();
    const Simplified simplified = simplify(lut);
    ASSERT_TRUE(simplified.lut.shaper && !simplified.lut.cube);
    EXPECT_EQ(simplified.lut.shaper->size(), 65);
    EXPECT_EQ(names_of(simplified), std::vector<std::string_view>{"separable"});
    EXPECT_LE(simplified.bound, 1e-7);
}

TEST(Simplify, keeps_a_cube_whose_channels_mix_by_more_than_the_tolerance) {
    Lut lut;
    lut.cube = sampled(test_looks()[1].f, 17);
    const Simplified simplified = simplify(lut);
    EXPECT_TRUE(simplified.omissions.empty());
    EXPECT_EQ(simplified.lut.cube, lut.cube);
}

TEST(Simplify, folds_a_straight_1d_table_into_the_cubes_domain) {
    Lut lut;
    lut.shaper = straight_table(1024, {{-1, 0, 0}, {3, 2, 1}}, {0, 0, 0}, {1, 1, 1});
    lut.cube = sampled(test_looks()[1].f, 17);
    const Simplified simplified = simplify(lut);
    ASSERT_EQ(names_of(simplified), std::vector<std::string_view>{"linear-shaper"});
    EXPECT_EQ(simplified.lut.cube->domain, lut.shaper->domain);
    expect_equal_within_bound(lut, simplified, "straight table");
    // Beyond the domain both stand still.
    const RgbD out = evaluate_exact(lut, {9, -9, 9});
    EXPECT_LE(largest_magnitude(out - evaluate_exact(simplified.lut, {9, -9, 9})), 1e-6);
}

TEST(Simplify, keeps_a_straight_1d_table_whose_ends_clamp_before_the_cube_does) {
    Lut lut;
    lut.shaper = straight_table(64, {}, {0.1F, 0.1F, 0.1F}, {0.9F, 0.9F, 0.9F});
    lut.cube = sampled(test_looks()[1].f, 17);
    EXPECT_TRUE(simplify(lut).omissions.empty());
}

TEST(Simplify, keeps_a_bent_1d_table_and_drops_the_identity_cube_behind_it) {
    Lut lut;
    lut.shaper = straight_table(65, {}, {0, 0, 0}, {1, 1, 1});
    for (Rgb& entry : lut.shaper->entries) {
        entry.g = entry.g * entry.g;
    }
    lut.cube = identity_cube(9);
    const Simplified simplified = simplify(lut);
    EXPECT_EQ(names_of(simplified), std::vector<std::string_view>{"identity-cube"});
    EXPECT_EQ(simplified.lut.shaper, lut.shaper);
}

TEST(Simplify, drops_nodes_that_interpolation_gives) {
    Lut lut;
    lut.cube = identity_cube(33);
    for (Rgb& node : lut.cube->nodes) {
        node = {0.5F * node.r + 0.5F * node.g, node.g, 0.25F * node.r + 0.75F * node.b};
    }
    const Simplified simplified = simplify(lut);
    ASSERT_EQ(names_of(simplified), std::vector<std::string_view>{"fewer-nodes"});
    EXPECT_EQ(simplified.lut.cube->size, 2);
    expect_equal_within_bound(lut, simplified, "matrix");
}

TEST(Simplify, has_a_rule_of_every_name_that_some_look_needs) {
    std::set<std::string_view> used, names;
    for (const StiffLook& row : stiff_suite()) {
        for (const std::string_view name : names_of(simplify(row.make()))) {
            used.insert(name);
        }
    }
    Lut shaped;
    shaped.shaper = straight_table(64, {}, {0, 0, 0}, {1, 1, 1});
    shaped.cube = identity_cube(5);
    for (const std::string_view name : names_of(simplify(shaped))) {
        used.insert(name);
    }
    Lut curve;
    curve.shaper = straight_table(64, {}, {0, 0, 0}, {1, 1, 1});
    for (const std::string_view name : names_of(simplify(curve))) {
        used.insert(name);
    }
    for (const SimplifyRule& rule : simplify_rules()) {
        EXPECT_TRUE(names.insert(rule.name).second);
        EXPECT_TRUE(used.count(rule.name)) << rule.name;
    }
}

TEST(UnreachableNodes, are_those_that_no_input_can_change) {
    Lut wide;
    wide.cube = identity_cube(33, {{0, 0, 0}, {4, 4, 4}});
    EXPECT_EQ(unreachable_nodes(wide).nodes, 0U);
    EXPECT_EQ(unreachable_nodes(wide).of_engine, 33U * 33 * 33 - 9U * 9 * 9);
    Lut shaped;
    shaped.cube = sampled(test_looks()[1].f, 9);
    shaped.shaper = straight_table(16, {}, {0.25F, 0, 0}, {0.5F, 1, 1});
    const Unreachable found = unreachable_nodes(shaped);
    EXPECT_EQ(found.nodes, 9U * 9 * 9 - 3U * 9 * 9);
    // What cannot be reached may be anything.
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 2);
    Lut other = shaped;
    for (int b = 0; b < 9; ++b) {
        for (int g = 0; g < 9; ++g) {
            for (int r = 0; r < 9; ++r) {
                if (r < 2 || r > 4) {
                    other.cube->at(r, g, b) = {99, 99, 99};
                }
            }
        }
    }
    for (int i = 0; i < 2000; ++i) {
        const RgbD in{unit(random), unit(random), unit(random)};
        EXPECT_EQ(evaluate_exact(shaped, in), evaluate_exact(other, in));
    }
}

} // namespace
} // namespace lutlib
