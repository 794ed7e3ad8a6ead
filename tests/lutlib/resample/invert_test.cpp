#include "lutlib/resample/invert.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/limits.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/recipe/bake_recipe.h"
#include "tests/lutlib/looks.h"
#include "tests/lutlib/resample/inverse_looks.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <cmath>
#include <random>

namespace lutlib {
namespace {

double round_trip(const Lut& look, const Lut& inverse, const std::vector<Rgb>& inputs) {
    double worst = 0;
    for (const Rgb& in : inputs) {
        const RgbD back = evaluate_exact(inverse, evaluate_exact(look, to_double(in)));
        worst = std::max(worst, largest_magnitude(back - to_double(in)));
    }
    return worst;
}

TEST(Invert, of_the_identity_is_the_identity_and_complete) {
    for (const Domain& domain : {Domain{}, Domain{{-1, 0, 0.5F}, {2, 4, 1}}}) {
        InvertOptions options;
        options.domain = domain;
        const Inversion out = invert(cube_look(identity_cube(9, domain)), options);
        EXPECT_EQ(out.out_of_gamut.count, 0U);
        EXPECT_EQ(out.folded.count, 0U);
        const Lut3D wanted = identity_cube(9, domain);
        for (std::size_t i = 0; i < wanted.nodes.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(out.lut.cube->nodes[i][c], wanted.nodes[i][c], 1e-6);
            }
        }
    }
}

TEST(Invert, holds_an_exact_inverse_at_every_node_within_the_gamut) {
    const Lut look = cube_look(sampled(gentle, 17));
    const Inversion out = invert(look, {});
    std::size_t exact = 0;
    const Lut3D& inverse = *out.lut.cube;
    for (int b = 0; b < inverse.size; ++b) {
        for (int g = 0; g < inverse.size; ++g) {
            for (int r = 0; r < inverse.size; ++r) {
                const RgbD wanted = node_position(inverse, r, g, b);
                const RgbD d = evaluate_exact(look, to_double(inverse.at(r, g, b))) - wanted;
                exact += largest_magnitude(d) < 1e-6;
            }
        }
    }
    EXPECT_EQ(exact, out.nodes - out.out_of_gamut.count);
    EXPECT_EQ(out.folded.count, 0U);
    EXPECT_GT(exact, out.nodes / 2);
}

TEST(Invert, undoes_an_invertible_look_within_a_bound_that_falls_with_the_square_of_the_step) {
    const Lut look = cube_look(sampled(gentle, 33));
    std::vector<Rgb> inputs;
    // Away from the gamut's surface, where a cell of the inverse also holds colours out of gamut.
    for (const Rgb& in : samples_over({{.15F, .15F, .15F}, {.85F, .85F, .85F}}, 9, 5000)) {
        inputs.push_back(in);
    }
    const auto error = [&](int size) {
        InvertOptions options;
        options.size = size;
        return round_trip(look, invert(look, options).lut, inputs);
    };
    const double coarse = error(9), fine = error(33);
    EXPECT_LT(coarse, 4e-3);
    EXPECT_LT(fine, 5e-4);
    EXPECT_LT(fine, coarse / 8);
}

TEST(Invert, says_where_a_color_cannot_be_given) {
    // Outputs fill 0.25..0.75 only.
    const Lut look = cube_look(sampled(
        [](RgbD c) {
            return RgbD{.25 + .5 * c.r, .25 + .5 * c.g, .25 + .5 * c.b};
        },
        9));
    const Inversion out = invert(look, {.outside = Outside::nearest});
    std::size_t outside = 0;
    for (const Rgb& wanted : identity_cube(9).nodes) {
        outside += std::min({wanted.r, wanted.g, wanted.b}) < 0.25F ||
                   std::max({wanted.r, wanted.g, wanted.b}) > 0.75F;
    }
    EXPECT_EQ(out.out_of_gamut.count, outside);
    EXPECT_NEAR(out.out_of_gamut.extent, 0.25, 1e-6);
    EXPECT_EQ(out.out_of_gamut.low, (Rgb{0, 0, 0}));
    EXPECT_EQ(out.out_of_gamut.high, (Rgb{1, 1, 1}));
    // Filled with the nearest that there is.
    EXPECT_NEAR(out.lut.cube->at(0, 0, 0).r, 0, 1e-6);
    EXPECT_NEAR(out.lut.cube->at(8, 0, 8).b, 1, 1e-6);
    EXPECT_NEAR(out.lut.cube->at(8, 4, 0).g, 0.5, 1e-6);
}

TEST(Invert, finds_the_nearest_color_that_a_look_can_give) {
    const Lut look = cube_look(sampled(gentle, 17));
    const Inversion out = invert(look, {.outside = Outside::nearest});
    ASSERT_GT(out.out_of_gamut.count, 0U);
    // Against a search over a fine lattice of inputs, for a colour at a corner.
    const RgbD wanted{1, 0, 0};
    const RgbD got = evaluate_exact(look, to_double(out.lut.cube->at(16, 0, 0)));
    const auto distance = [&](RgbD c) {
        const RgbD d = c - wanted;
        return d.r * d.r + d.g * d.g + d.b * d.b;
    };
    double best = 9;
    for (const Rgb& in : identity_cube(65).nodes) {
        best = std::min(best, distance(evaluate_exact(look, to_double(in))));
    }
    EXPECT_LE(distance(got), best + 1e-9);
}

TEST(Invert, says_where_a_look_folds) {
    // Red turns back at 0.7: outputs from 0.4 to 0.7 in red have two inputs.
    const auto fold = [](RgbD c) { return RgbD{c.r <= 0.75 ? c.r : 1.5 - c.r, c.g, c.b}; };
    const Lut look = cube_look(sampled(fold, 17));
    InvertOptions options;
    options.size = 17;
    const Inversion out = invert(look, options);
    // Nodes at 12/16 have one input; those of 13 to 16 none; 12 down to 8 are reached twice.
    EXPECT_EQ(out.out_of_gamut.count, 4U * 17 * 17);
    EXPECT_EQ(out.folded.count, 4U * 17 * 17);
    EXPECT_NEAR(out.folded.low.r, 0.5, 1e-6);
    EXPECT_NEAR(out.folded.high.r, 0.6875, 1e-6);
    EXPECT_NEAR(out.folded.extent, 0.5, 1e-6);
    // Of two inputs the one on the sheet that does not fold.
    EXPECT_NEAR(out.lut.cube->at(9, 3, 5).r, 9.0 / 16, 1e-6);
}

TEST(Invert, undoes_a_clipped_look_where_it_is_not_clipped) {
    const Lut look = cube_look(sampled(
        [](RgbD c) {
            return saturate(RgbD{2 * c.r - .5, 2 * c.g - .5, 2 * c.b - .5});
        },
        33));
    const Inversion out = invert(look, {});
    EXPECT_EQ(out.out_of_gamut.count, 0U);
    // Of an eighth of its inputs no channel is clipped; no two of them give one colour.
    EXPECT_NEAR(out.inputs.undoable, 0.125, 1e-9);
    EXPECT_NEAR(out.inputs.flat, 0.875, 1e-9);
    EXPECT_EQ(out.inputs.folded, 0);
    EXPECT_EQ(out.folded.count, 0U);
    EXPECT_EQ(out.flat.count, 33U * 33 * 33 - 31U * 31 * 31);
    EXPECT_LT(round_trip(look, out.lut, samples_over({{.3F, .3F, .3F}, {.7F, .7F, .7F}}, 5, 2000)),
              1e-5);
}

// Every input above 0.75 gives white, every one below 0.25 black: they come back as themselves.
TEST(Invert, of_a_flat_set_takes_the_input_nearest_to_the_color_itself) {
    const Lut look = cube_look(sampled(
        [](RgbD c) {
            const double y = test_luma(c);
            const auto bend = [y](double v) {
                return std::clamp(2 * (y + 0.8 * (v - y)) - .5, 0., 1.);
            };
            return RgbD{bend(c.r), bend(c.g), bend(c.b)};
        },
        33));
    const Lut3D inverse = *invert(look, {}).lut.cube;
    const Rgb white = inverse.at(32, 32, 32), black = inverse.at(0, 0, 0);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(white[c], 1, 1e-6);
        EXPECT_NEAR(black[c], 0, 1e-6);
    }
    // Of pure red too, by brute force over inputs.
    const RgbD found = to_double(inverse.at(32, 0, 0));
    EXPECT_LT(largest_magnitude(evaluate_exact(look, found) - RgbD{1, 0, 0}), 1e-6);
    double nearest = 9;
    for (const Rgb& in : identity_cube(65).nodes) {
        const RgbD d = to_double(in) - RgbD{1, 0, 0};
        if (largest_magnitude(evaluate_exact(look, to_double(in)) - RgbD{1, 0, 0}) < 1e-9) {
            nearest = std::min(nearest, std::sqrt(d.r * d.r + d.g * d.g + d.b * d.b));
        }
    }
    const RgbD d = found - RgbD{1, 0, 0};
    EXPECT_LE(std::sqrt(d.r * d.r + d.g * d.g + d.b * d.b), nearest + 1e-6);
}

// A look whose outputs end within the last cell of its inverse.
// Beside a clipped colour the nearest input of a flat set would be wrong for the cell's own
// colours.
TEST(Invert, goes_on_from_what_can_be_undone_into_flat_sets) {
    const Lut look = cube_look(sampled(
        [](RgbD c) {
            const double y = test_luma(c);
            const auto saturate_more = [y](double v) {
                return std::clamp(y + 1.6 * (v - y), 0., 1.);
            };
            return RgbD{saturate_more(c.r), saturate_more(c.g), saturate_more(c.b)};
        },
        9));
    const auto mean_error = [&](Outside outside) {
        InvertOptions options;
        options.outside = outside;
        const Inversion inversion = invert(look, options);
        double sum = 0;
        for (const Rgb& in : inversion.undoable) {
            const RgbD out = evaluate_exact(look, to_double(in));
            sum += largest_magnitude(evaluate_exact(inversion.lut, out) - to_double(in));
        }
        return sum / static_cast<double>(inversion.undoable.size());
    };
    EXPECT_LT(mean_error(Outside::extrapolate), 0.02);
    EXPECT_GT(mean_error(Outside::nearest), 2 * mean_error(Outside::extrapolate));
}

TEST(Invert, continues_beyond_the_gamut_where_a_cell_holds_colors_inside) {
    const auto smaller = [](RgbD c) {
        const double y = test_luma(c);
        return RgbD{.01 + .97 * (.2 * y + .8 * c.r), .01 + .97 * (.2 * y + .8 * c.g),
                    .01 + .97 * (.2 * y + .8 * c.b)};
    };
    const Lut look = cube_look(sampled(smaller, 17));
    const std::vector<Rgb> inputs = samples_over({}, 17, 20000);
    const auto error = [&](Outside outside) {
        return round_trip(look, invert(look, {.outside = outside}).lut, inputs);
    };
    // The look is affine, so that its inverse is, and cells hold all of it.
    EXPECT_GT(error(Outside::nearest), 0.01);
    EXPECT_LT(error(Outside::extrapolate), 2e-3);
    EXPECT_THROW(invert(look, {.outside = Outside::refuse}), Error);
    EXPECT_NO_THROW(invert(cube_look(identity_cube(5)), {.outside = Outside::refuse}));
}

TEST(Invert, takes_a_domain_for_each_channel) {
    const Lut look = cube_look(identity_cube(17, {{0, -1, 0}, {1, 1, 4}}));
    const Domain domain{{0, -1, 0}, {1, 1, 4}};
    const Inversion out = invert(look, {.domain = domain});
    EXPECT_EQ(out.lut.domain(), domain);
    EXPECT_EQ(out.out_of_gamut.count, 0U);
    EXPECT_NEAR(evaluate_exact(out.lut, {.3, -.7, 3.1}).b, 3.1, 1e-6);
}

TEST(Invert, of_values_as_wide_as_floats_says_that_the_domain_is_too_wide) {
    Lut look = cube_look(identity_cube(2));
    look.cube->nodes.front() = {-3.4e38F, -3.4e38F, -3.4e38F};
    look.cube->nodes.back() = {3.4e38F, 3.4e38F, 3.4e38F};
    try {
        invert(look, {});
        FAIL() << "was inverted";
    } catch (const Error& error) {
        EXPECT_NE(error.message().find("wider than a float can say"), std::string::npos)
            << error.message();
    }
}

TEST(Invert, of_a_constant_look_is_filled_and_says_so) {
    const Lut look = cube_look(sampled([](RgbD) { return RgbD{.5, .5, .5}; }, 5));
    const Inversion out = invert(look, {});
    EXPECT_EQ(out.out_of_gamut.count, out.nodes - 1);
    for (const Rgb& c : out.lut.cube->nodes) {
        EXPECT_TRUE(std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b));
    }
}

Lut3D noise(int size) {
    Lut3D out = identity_cube(size);
    std::mt19937 random(1);
    for (Rgb& node : out.nodes) {
        for (std::size_t c = 0; c < 3; ++c) {
            node[c] = static_cast<float>(static_cast<double>(random()) / 4294967295.0);
        }
    }
    return out;
}

// Each cell of it touches about half of all buckets: on the finest grid of 49 nodes more than 2^32
// entries, of 25 still more than the limit.
TEST(Invert, of_noise_takes_no_more_memory_than_the_limit) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    rusage before{}, after{};
    const Lut look = cube_look(noise(support::is_thorough() ? 49 : support::is_sanitized ? 9 : 25));
    getrusage(RUSAGE_SELF, &before);
    InvertOptions options;
    options.size = 2;
    options.outside = Outside::nearest;
    const Inversion out = invert(look, options);
    getrusage(RUSAGE_SELF, &after);
    constexpr std::size_t kibibyte = 1024, other = std::size_t{64} << 20;
    EXPECT_LT(static_cast<std::size_t>(after.ru_maxrss - before.ru_maxrss) * kibibyte,
              4 * limits::max_output_index_entries + other);
    for (const Rgb& c : out.lut.cube->nodes) {
        EXPECT_EQ(saturate(c), c);
    }
    // Coarser buckets lose nothing: what is found gives the wanted colour.
    options.domain = Domain{{.4F, .4F, .4F}, {.6F, .6F, .6F}};
    const Inversion inner = invert(look, options);
    EXPECT_EQ(inner.folded.count, inner.nodes);
    for (std::size_t i = 0; i < inner.nodes; ++i) {
        const RgbD wanted = to_double(identity_cube(2, *options.domain).nodes[i]);
        const RgbD got = evaluate_exact(look, to_double(inner.lut.cube->nodes[i]));
        EXPECT_LT(largest_magnitude(got - wanted), 1e-4);
    }
}

// Nothing of the Jacobian's square remains in the directions that a grey look lacks.
TEST(Invert, of_a_look_of_one_dimension_is_finite) {
    for (const double scale : {1.0, 1e-3, 0.3, 3.0}) {
        Lut look = cube_look(identity_cube(9));
        for (Rgb& c : look.cube->nodes) {
            const double y = scale * test_luma(to_double(c));
            c = to_float({y, y * y, std::sqrt(y)});
        }
        const Inversion out = invert(look, {.outside = Outside::nearest});
        for (const Rgb& c : out.lut.cube->nodes) {
            EXPECT_EQ(saturate(c), c);
        }
    }
}

} // namespace
} // namespace lutlib
