#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/match/greys.h"
#include "lutlib/match/held_out.h"
#include "lutlib/match/match_look.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/metrics/viewing.h"
#include "tests/lutlib/looks.h"
#include "tests/lutlib/match/pairs.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <limits>

namespace lutlib {
namespace {

const int usual_size = support::is_sanitized ? 9 : 17;
// Errors of fewer nodes grow with the square of their distance.
const double coarseness = support::is_sanitized ? 4 : 1;

Lut lut_of(const Match& match) {
    Lut out;
    out.cube = match.cube;
    return out;
}

// dE2000 of the look's exact results, at the colours of the pairs.
ErrorStats errors(const Match& match, RgbD (*look)(RgbD), const std::vector<PixelPair>& pairs) {
    const Lut lut = lut_of(match);
    std::vector<RgbD> wanted, found;
    for (const PixelPair& pair : pairs) {
        wanted.push_back(saturate(look(to_double(pair.before))));
        found.push_back(saturate(evaluate_exact(lut, to_double(pair.before))));
    }
    std::vector<double> out(wanted.size());
    Eye{Viewing{}}(Metric::delta_e_2000, wanted, found, out);
    return error_stats(std::move(out));
}

TEST(MatchLook, learns_each_look_from_rounded_pixels) {
    for (const TestLook& look : test_looks()) {
        const std::vector<PixelPair> pairs = picture_pairs(look.f, 60000);
        const Match match = match_look(pairs, {usual_size, 8});
        const ErrorStats off = errors(match, look.f, pairs);
        // Kinks, where it clips, between nodes that are a sixteenth apart.
        const bool bends =
            std::string(look.name) == "clipped" || std::string(look.name) == "saturated";
        EXPECT_LT(off.mean, coarseness * (bends ? 0.5 : 0.2)) << look.name;
        EXPECT_LT(off.p99, coarseness * (bends ? 4 : 1)) << look.name;
    }
}

TEST(MatchLook, saturated_colours_that_no_pixel_shows_follow_the_others) {
    const auto muted = test_looks()[2].f;
    const std::vector<PixelPair> seen = picture_pairs(muted, 60000);
    std::vector<PixelPair> unseen;
    for (const RgbD c : {RgbD{0.9, 0.1, 0.1}, RgbD{0.1, 0.8, 0.2}, RgbD{0.1, 0.1, 0.9},
                         RgbD{0.9, 0.8, 0.1}, RgbD{0.9, 0.1, 0.8}}) {
        unseen.push_back({to_float(c), {}});
    }
    EXPECT_LT(errors(match_look(seen, {usual_size, 8}), muted, unseen).max, 4);
}

TEST(MatchLook, learns_a_bend_that_lies_between_tetrahedra_to_less_than_a_code) {
    // Straight within each tetrahedron, whatever the size of the lattice; steep, and bent at greys.
    const auto bent = [](RgbD c) {
        return RgbD{0.2 + 0.6 * c.r, 0.6 - 0.5 * std::abs(c.r - c.g),
                    0.1 + 0.8 * std::max(c.g, c.b)};
    };
    const std::vector<PixelPair> pairs = picture_pairs(bent, 60000);
    const Match match = match_look(pairs, {usual_size, 8});
    double sum = 0, most = 0;
    for (const PixelPair& pair : pairs) {
        const RgbD before = to_double(pair.before);
        const double off = largest_magnitude(evaluate_exact(lut_of(match), before) - bent(before));
        sum += off;
        most = std::max(most, off);
    }
    EXPECT_LT(255 * sum / static_cast<double>(pairs.size()), coarseness * 0.2);
    EXPECT_LT(255 * most, coarseness * 2);
}

TEST(MatchLook, does_not_learn_what_a_part_of_the_pixels_says_alone) {
    const auto look = test_looks()[2].f;
    std::vector<PixelPair> pairs = picture_pairs(look, 60000);
    const std::vector<PixelPair> clean = pairs;
    for (std::size_t i = 0; i < pairs.size(); i += 12) {
        pairs[i].after = {0.2F, 0.9F, 0.2F};
    }
    const ErrorStats off = errors(match_look(pairs, {usual_size, 8}), look, clean);
    EXPECT_LT(off.mean, 0.25);
    EXPECT_LT(off.p99, 1);
}

TEST(MatchLook, starting_from_a_look_of_most_pixels_ends_where_starting_anew_does) {
    const auto look = test_looks()[1].f;
    const std::vector<PixelPair> pairs = picture_pairs(look, 40000);
    const std::vector<PixelPair> most(pairs.begin(), pairs.begin() + 35000);
    const MatchSettings settings{usual_size, 8};
    const Match first = match_look(most, settings);
    const Match again = match_look(pairs, settings, &first), anew = match_look(pairs, settings);
    double off = 0;
    for (const PixelPair& pair : pairs) {
        off =
            std::max(off, largest_magnitude(evaluate_exact(lut_of(again), to_double(pair.before)) -
                                            evaluate_exact(lut_of(anew), to_double(pair.before))));
    }
    EXPECT_LT(off, 1.0 / 255);
}

TEST(MatchLook, rises_along_the_greys_unless_the_pixels_fall) {
    const auto rising_greys = [](const Match& match) {
        for (int i = 0; i + 1 < match.cube.size; ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                if (match.cube.at(i + 1, i + 1, i + 1)[c] < match.cube.at(i, i, i)[c] - 1e-6F) {
                    return false;
                }
            }
        }
        return true;
    };
    // Dark colours alone: bright greys are anybody's guess.
    std::vector<PixelPair> dark = picture_pairs(
        [](RgbD c) {
            return RgbD{c.r * (1.2 - c.r), c.g, c.b};
        },
        60000);
    std::erase_if(dark, [](const PixelPair& pair) { return pair.before.g > 0.5F; });
    EXPECT_TRUE(rising_greys(match_look(dark, {usual_size, 8})));
    const auto solarised = [](RgbD c) { return RgbD{4 * c.r * (1 - c.r), c.g, c.b}; };
    const Match falls = match_look(picture_pairs(solarised, 60000), {usual_size, 8});
    EXPECT_TRUE(falls.greys_fall[0]);
    EXPECT_FALSE(falls.greys_fall[1]);
    EXPECT_FALSE(rising_greys(falls));
}

TEST(MatchLook, is_finite_for_odd_input_and_refuses_none) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(match_look({}), Error);
    EXPECT_THROW(match_look({{{nan, 0, 0}, {0, 0, 0}}}), Error);
    EXPECT_THROW(match_look({{{0, 0, 0}, {0, 0, 0}}}, {1, 8}), Error);
    for (const PixelPair& one :
         {PixelPair{{0.5F, 0.5F, 0.5F}, {0.25F, 0.5F, 0.5F}}, PixelPair{{0, 0, 0}, {1, 1, 1}},
          PixelPair{{-40, 1e30F, 7}, {-1e30F, 0, 3}}}) {
        const Match match = match_look({one}, {5, 0});
        EXPECT_NO_THROW(validate(lut_of(match)));
    }
}

TEST(MakeGreysRise, moves_what_falls_and_leaves_colours_far_from_it) {
    Lut3D cube = identity_cube(17);
    const Lut3D before = cube;
    cube.at(8, 8, 8).g = 0.4F;
    std::vector<double> support(cube.nodes.size());
    const std::array<bool, 3> falls = make_greys_rise(cube, support, 0.001);
    EXPECT_EQ(falls, (std::array<bool, 3>{false, false, false}));
    for (int i = 0; i < 16; ++i) {
        EXPECT_LE(cube.at(i, i, i).g, cube.at(i + 1, i + 1, i + 1).g + 1e-6F);
    }
    EXPECT_EQ(cube.at(16, 0, 0), before.at(16, 0, 0));
    EXPECT_EQ(cube.at(8, 8, 8).r, before.at(8, 8, 8).r);
    // Pixels say so.
    cube.at(8, 8, 8).g = 0.3F;
    support.assign(support.size(), 100);
    const Lut3D said = cube;
    EXPECT_TRUE(make_greys_rise(cube, support, 0.001)[1]);
    EXPECT_EQ(cube, said);
}

TEST(HeldOut, is_an_eighth_of_a_picture_in_tiles) {
    int count = 0;
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            count += is_held_out(x, y) ? 1 : 0;
            EXPECT_EQ(is_held_out(x, y), is_held_out(x / 16 * 16, y / 16 * 16));
        }
    }
    EXPECT_EQ(count, 256 * 256 / 8);
}

} // namespace
} // namespace lutlib
