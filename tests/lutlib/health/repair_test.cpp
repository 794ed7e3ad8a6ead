#include "lutlib/error.h"
#include "lutlib/health/health.h"
#include "lutlib/health/repair.h"
#include "lutlib/survey/stiff_suite.h"
#include "tests/lutlib/looks.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace lutlib {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

double largest_difference(const Lut3D& a, const Lut3D& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        most = std::max(most, largest_magnitude(to_double(a.nodes[i]) - to_double(b.nodes[i])));
    }
    return most;
}

TEST(Repair, leaves_sound_looks_exactly_as_they_are) {
    for (const char* name :
         {"identity", "permuted", "swapped", "folded", "shoulder_64", "step_luma", "constant_grey",
          "inverted", "gain_1000", "shaped_log", "domain_narrow", "noise", "posterised"}) {
        const Lut lut = stiff_look_named(name)->make();
        const Repaired repaired = repair(lut);
        for (const RepairStep& step : repaired.steps) {
            // Noise has falling neutrals, and nodes that stand out among the quieter.
            EXPECT_EQ(std::string_view(name), "noise") << name << ": " << step.words;
        }
        EXPECT_TRUE(!repaired.steps.empty() || repaired.lut.cube == lut.cube) << name;
    }
    for (const TestLook& look : test_looks()) {
        Lut lut;
        lut.cube = sampled(look.f, 17);
        EXPECT_TRUE(repair(lut).steps.empty()) << look.name;
    }
    // A kink in the sum of the channels is no row of spikes.
    Lut kinked;
    kinked.cube = sampled(
        [](RgbD c) {
            const double bright = std::max(c.r + c.g + c.b - 1.5, 0.0);
            return RgbD{bright, bright, bright};
        },
        9);
    EXPECT_TRUE(repair(kinked).steps.empty());
}

TEST(Repair, fills_holes_in_a_straight_look_exactly_corners_and_whole_planes_too) {
    Lut lut;
    lut.cube = identity_cube(9);
    const Lut3D whole = *lut.cube;
    const auto pierce = [&](int r, int g, int b) { lut.cube->at(r, g, b) = {nan, nan, nan}; };
    pierce(0, 0, 0);
    pierce(8, 8, 8);
    pierce(4, 4, 4);
    lut.cube->at(3, 2, 1).g = std::numeric_limits<float>::infinity();
    for (int g = 0; g < 9; ++g) {
        for (int b = 0; b < 9; ++b) {
            pierce(6, g, b);
            pierce(7, g, b);
        }
    }
    const Repaired repaired = repair(lut);
    ASSERT_EQ(repaired.steps.size(), 1U);
    EXPECT_EQ(repaired.steps[0].name, "non-finite");
    EXPECT_EQ(repaired.steps[0].changed, 3U * (3 + 2 * 81) + 1);
    EXPECT_EQ(repaired.steps[0].largest, 0);
    EXPECT_LT(largest_difference(*repaired.lut.cube, whole), 1e-6);
}

TEST(Repair, fills_holes_in_a_1d_table_between_and_beyond_its_numbers) {
    Lut lut;
    lut.shaper = Lut1D{{}, {{nan, 0, 0}, {0.25F, nan, 0.2F}, {0.5F, nan, 0.4F}, {1, 0.9F, nan}}};
    const std::vector<Rgb> entries = repair(lut).lut.shaper->entries;
    EXPECT_FLOAT_EQ(entries[0].r, 0.25F);
    EXPECT_FLOAT_EQ(entries[1].g, 0.3F);
    EXPECT_FLOAT_EQ(entries[2].g, 0.6F);
    EXPECT_FLOAT_EQ(entries[3].b, 0.4F);
}

TEST(Repair, refuses_a_channel_without_a_single_number) {
    Lut lut;
    lut.cube = identity_cube(3);
    for (Rgb& node : lut.cube->nodes) {
        node.g = nan;
    }
    EXPECT_THROW(repair(lut), Error);
}

TEST(Repair, levels_single_nodes_that_stand_out) {
    for (const char* name : {"spike", "spike_100"}) {
        const Repaired repaired = repair(stiff_look_named(name)->make());
        ASSERT_EQ(repaired.steps.size(), 1U) << name;
        EXPECT_EQ(repaired.steps[0].name, "spikes");
        EXPECT_EQ(repaired.steps[0].changed, 3U);
        EXPECT_LT(largest_difference(*repaired.lut.cube, identity_cube(33)), 1e-6) << name;
    }
}

// On corners, edges and faces, and whatever the size of the look's values.
TEST(Repair, levels_a_spike_wherever_it_stands_exactly) {
    for (const float scale : {1.0F, 1e-3F, 50.0F}) {
        Lut whole;
        whole.cube = identity_cube(17);
        for (Rgb& node : whole.cube->nodes) {
            node = {scale * node.r, scale * node.g, scale * node.b};
        }
        for (const std::array<int, 3> at :
             {std::array{0, 0, 0}, {16, 16, 16}, {16, 0, 7}, {0, 16, 16}, {5, 9, 0}, {8, 8, 8}}) {
            Lut lut = whole;
            Rgb& node = lut.cube->at(at[0], at[1], at[2]);
            node = {node.r + 0.4F * scale, node.g + 0.4F * scale, node.b + 0.4F * scale};
            const Repaired repaired = repair(lut);
            ASSERT_EQ(repaired.steps.size(), 1U) << at[0] << at[1] << at[2] << ' ' << scale;
            EXPECT_EQ(repaired.steps[0].name, "spikes");
            EXPECT_EQ(repaired.steps[0].changed, 3U);
            EXPECT_GT(repaired.steps[0].to_eye.max, 0);
            EXPECT_LT(largest_difference(*repaired.lut.cube, *whole.cube), 2e-6 * scale)
                << at[0] << at[1] << at[2] << ' ' << scale;
        }
    }
}

// Red bends so much that its part would not be told from a bend; green's and blue's are.
TEST(Repair, levels_all_channels_of_a_node_that_stands_out_so_that_none_tints_it) {
    Lut whole;
    whole.cube = identity_cube(33);
    for (Rgb& node : whole.cube->nodes) {
        node.r += 0.004F * std::sin(40 * node.r);
    }
    Lut lut = whole;
    Rgb& node = lut.cube->at(16, 16, 16);
    node = {1.06F * node.r, 1.06F * node.g, 1.06F * node.b};
    const Repaired repaired = repair(lut);
    ASSERT_EQ(repaired.steps.size(), 1U);
    EXPECT_EQ(repaired.steps[0].changed, 3U);
    const Rgb &is = repaired.lut.cube->at(16, 16, 16), &was = whole.cube->at(16, 16, 16);
    EXPECT_NEAR(is.r, was.r, 0.007F); // as red bends there
    EXPECT_NEAR(is.g, was.g, 1e-6F);
    EXPECT_NEAR(is.b, was.b, 1e-6F);
}

// Neutrals that fall by less than anybody sees are no fault to be mended.
TEST(Repair, leaves_a_fall_of_neutrals_alone_that_is_a_note) {
    Lut lut;
    lut.cube = identity_cube(17);
    for (Rgb& node : lut.cube->nodes) {
        const float most = 0.9F + 0.0001F;
        const auto bend = [&](float v) { return v > 0.9F ? most - (v - 0.9F) * 0.002F : v; };
        node = {bend(node.r), bend(node.g), bend(node.b)};
    }
    ASSERT_GT(examine(lut).neutral_fall.value, 1e-5);
    EXPECT_TRUE(repair(lut).steps.empty());
}

TEST(Repair, never_gives_values_that_the_look_did_not) {
    Lut lut;
    lut.cube = identity_cube(17);
    // White is darker than the greys below it, and the look ends at 1.
    for (int b = 12; b < 17; ++b) {
        for (int g = 12; g < 17; ++g) {
            for (int r = 12; r < 17; ++r) {
                lut.cube->at(r, g, b) = {1 - 0.02F * static_cast<float>(r - 12),
                                         1 - 0.02F * static_cast<float>(g - 12),
                                         1 - 0.02F * static_cast<float>(b - 12)};
            }
        }
    }
    const Health before = examine(lut);
    const Repaired repaired = repair(lut);
    const Health after = examine(repaired.lut);
    EXPECT_GE(after.lowest.value, before.lowest.value);
    EXPECT_LE(after.highest.value, before.highest.value);
    for (const HealthCheck& check : health_checks()) {
        EXPECT_LE(check.judge(after).severity, check.judge(before).severity) << check.name;
    }
}

TEST(Repair, levels_a_spike_that_hides_beside_a_taller_one) {
    Lut lut;
    lut.cube = identity_cube(9);
    const Lut3D whole = *lut.cube;
    lut.cube->at(4, 4, 4) = {9, 9, 9};
    lut.cube->at(5, 5, 4) = {1, 1, 1};
    const Repaired repaired = repair(lut);
    ASSERT_EQ(repaired.steps.size(), 1U);
    EXPECT_EQ(repaired.steps[0].name, "spikes");
    EXPECT_EQ(repaired.steps[0].changed, 6U);
    EXPECT_LT(largest_difference(*repaired.lut.cube, whole), 1e-6);
}

// Blue beyond 1 holds up the luma of white, whose red and green are lower than a grey's.
TEST(Repair, leaves_no_falling_neutrals_where_it_clamps) {
    Lut lut;
    lut.cube = sampled(
        [](RgbD c) {
            const double level = (c.r + c.g + c.b) / 3, from_peak = level - 0.9;
            const double grey = 0.9 - 0.4 * from_peak * from_peak;
            return RgbD{grey, grey, 3 * level};
        },
        9);
    ASSERT_TRUE(repair(lut).steps.empty());
    const Repaired repaired = repair(lut, {.clamp = true});
    // What is left is less than anybody sees.
    EXPECT_LT(examine(repaired.lut).neutral_fall.value, 0.5 / 255);
    EXPECT_EQ(examine(repaired.lut).outside, 0U);
}

TEST(Repair, stops_neutrals_from_falling_without_touching_saturated_colors) {
    Lut lut;
    lut.cube = identity_cube(17);
    // A dent about the neutral axis, too wide to be a spike.
    for (int b = 0; b < 17; ++b) {
        for (int g = 0; g < 17; ++g) {
            for (int r = 0; r < 17; ++r) {
                const double level = (r + g + b) / 48.0 - 0.5;
                const auto dent = static_cast<float>(0.3 * std::exp(-80 * level * level));
                lut.cube->at(r, g, b) = lut.cube->at(r, g, b) - Rgb{dent, dent, dent};
            }
        }
    }
    ASSERT_GT(examine(lut).neutral_fall.value, 0.05);
    const Repaired repaired = repair(lut);
    ASSERT_EQ(repaired.steps.size(), 1U);
    EXPECT_EQ(repaired.steps[0].name, "neutral-axis");
    EXPECT_GT(repaired.steps[0].largest, 0.02);
    EXPECT_LT(examine(repaired.lut).neutral_fall.value, 1e-6);
    EXPECT_EQ(repaired.lut.cube->at(16, 0, 8), lut.cube->at(16, 0, 8));
    EXPECT_TRUE(repair(stiff_look_named("inverted")->make()).steps.empty());
}

TEST(Repair, makes_a_1d_table_stand_still_where_it_turned_back) {
    Lut lut;
    lut.shaper = Lut1D{{}, {{0, 1, 0}, {0.6F, 0.4F, 0.3F}, {0.4F, 0.6F, 0.6F}, {1, 0, 1}}};
    const Repaired repaired = repair(lut);
    EXPECT_FLOAT_EQ(repaired.lut.shaper->entries[1].r, 0.5F);
    EXPECT_FLOAT_EQ(repaired.lut.shaper->entries[2].r, 0.5F);
    EXPECT_FLOAT_EQ(repaired.lut.shaper->entries[1].g, 0.5F);
    EXPECT_FLOAT_EQ(repaired.lut.shaper->entries[1].b, 0.3F);
    ASSERT_EQ(repaired.steps.size(), 1U);
    EXPECT_EQ(repaired.steps[0].changed, 4U);
    EXPECT_NEAR(repaired.steps[0].largest, 0.1, 1e-6);
}

TEST(Repair, clamps_only_when_asked) {
    const Lut lut = stiff_look_named("gain_1000")->make();
    EXPECT_TRUE(repair(lut).steps.empty());
    const Repaired repaired = repair(lut, {.clamp = true});
    ASSERT_EQ(repaired.steps.size(), 1U);
    EXPECT_NEAR(repaired.steps[0].largest, 999, 1e-3);
    EXPECT_EQ(examine(repaired.lut).outside, 0U);
}

TEST(Repair, of_any_stiff_look_with_holes_is_sound_and_changes_nothing_a_second_time) {
    const int largest = support::is_sanitized ? 17 : 65;
    for (const StiffLook& row : stiff_suite()) {
        Lut lut = row.make();
        if (lut.cube && lut.cube->size > largest) {
            continue; // no other case, only more of it
        }
        std::vector<Rgb>& values = lut.cube ? lut.cube->nodes : lut.shaper->entries;
        for (std::size_t i = 3; i < values.size(); i += 97) {
            values[i].g = nan;
        }
        const Repaired once = repair(lut, {.clamp = true});
        EXPECT_NO_THROW(validate(once.lut)) << row.name;
        for (const RepairStep& step : once.steps) {
            EXPECT_TRUE(std::isfinite(step.largest)) << row.name << ": " << step.words;
        }
        for (const RepairStep& step : repair(once.lut, {.clamp = true}).steps) {
            ADD_FAILURE() << row.name << ": " << step.words << " by " << step.largest;
        }
    }
}

} // namespace
} // namespace lutlib
