#include "lutlib/io/fit_format.h"

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/formats.h"
#include "lutlib/metrics/samples.h"
#include "tests/lutlib/io/looks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lutlib::io {
namespace {

TEST(FitTo, keeps_a_domain_as_a_shaper_where_that_loses_nothing) {
    const Lut hdr = looks_of_every_shape()[1].lut;
    const Holds holds{.curve = true, .cube = true, .curve_and_cube = true, .curve_domain = true};
    const FitToFormat fit = fit_to(hdr, holds);
    EXPECT_TRUE(fit.losses.empty());
    EXPECT_TRUE(fit.lut.cube->domain.is_unit());
    const auto in = colors_in(hdr.domain());
    EXPECT_LE(largest_difference(evaluated(fit.lut, in), evaluated(hdr, in)), 1e-6);
}

TEST(FitTo, says_how_much_input_is_cut_where_a_domain_cannot_be_kept) {
    const Lut hdr = looks_of_every_shape()[1].lut;
    const FitToFormat fit = fit_to(hdr, Holds{.cube = true});
    ASSERT_FALSE(fit.losses.empty());
    EXPECT_EQ(fit.losses[0].what, "input 0..4 cut to 0..1");
    EXPECT_DOUBLE_EQ(fit.losses[0].figure, 3);
    EXPECT_EQ(fit.losses[0].unit, "units of input");
}

TEST(FitTo, counts_the_values_that_integers_clamp) {
    Lut lut;
    lut.cube = identity_cube(2);
    lut.cube->nodes[0] = {-0.5F, 0, 0};
    lut.cube->nodes[7] = {1.25F, 1.1F, 1};
    const FitToFormat fit = fit_to(lut, Holds{.cube = true, .integer_bits = 12});
    ASSERT_EQ(fit.losses.size(), 1U);
    EXPECT_EQ(fit.losses[0].what, "3 values outside 0..1 clamped, the furthest by");
    EXPECT_DOUBLE_EQ(fit.losses[0].figure, 0.5);
}

TEST(FitTo, sees_a_single_node_that_resampling_loses) {
    Lut spike;
    spike.cube = identity_cube(33);
    spike.cube->at(5, 17, 9) = {1, 0, 1};
    const FitToFormat fit = fit_to(spike, Holds{.cube = true}, 17);
    ASSERT_EQ(fit.losses.size(), 1U);
    EXPECT_GT(fit.losses[0].figure, 0.5);
}

// Two interpolations differ most between nodes: about one of many, in few of a lattice's cells.
TEST(FitTo, finds_the_largest_difference_of_interpolations_within_two_percent) {
    Lut spike;
    spike.cube = identity_cube(33);
    spike.cube->at(21, 6, 9).g += 0.4F;
    spike.interpolation = Interpolation::trilinear;
    const FitToFormat fit = fit_to(spike, Holds{.cube = true});
    ASSERT_EQ(fit.losses.size(), 1U);
    double most = 0;
    for (const Rgb& share : sample_colors(21, {.neutral = 0, .random = 0})) {
        const RgbD in{(20 + 2 * share.r) / 32.0, (5 + 2 * share.g) / 32.0,
                      (8 + 2 * share.b) / 32.0};
        most = std::max(
            most, largest_magnitude(evaluate_exact(*spike.cube, in, Interpolation::trilinear) -
                                    evaluate_exact(*spike.cube, in, Interpolation::tetrahedral)));
    }
    EXPECT_GT(most, 0.1);
    EXPECT_NEAR(fit.losses[0].figure, most, 0.02 * most);
}

TEST(FitTo, tells_keywords_that_the_format_drops) {
    Lut lut = looks_of_every_shape()[0].lut;
    lut.keywords = {"LUT_IN_VIDEO_RANGE", "VENDOR 1 2"};
    const FitToFormat fit = fit_to(lut, Holds{.cube = true});
    ASSERT_EQ(fit.losses.size(), 1U);
    EXPECT_NE(fit.losses[0].what.find("(LUT_IN_VIDEO_RANGE, VENDOR)"), std::string::npos);
    EXPECT_EQ(fit.losses[0].figure, 2);
    EXPECT_TRUE(fit_to(lut, Holds{.cube = true, .keywords = true}).losses.empty());
}

TEST(FitTo, tells_an_interpolation_that_the_format_drops_and_keeps_it_where_it_can) {
    Lut lut = looks_of_every_shape(5)[0].lut;
    for (const Interpolation how : {Interpolation::nearest, Interpolation::trilinear}) {
        lut.interpolation = how;
        const FitToFormat fit = fit_to(lut, Holds{.cube = true});
        ASSERT_EQ(fit.losses.size(), 1U);
        EXPECT_EQ(fit.losses[0].what.rfind(name_of(how), 0), 0U) << fit.losses[0].what;
        double most = 0;
        for (const Rgb& in : colors_in({})) {
            most = std::max(most, largest_magnitude(to_double(evaluate(fit.lut, in)) -
                                                    to_double(evaluate(lut, in))));
        }
        EXPECT_GT(most, 0);
        EXPECT_LE(most, 1.3 * fit.losses[0].figure);
    }
    const FitToFormat kept = fit_to(lut, Holds{.cube = true, .interpolation = true});
    EXPECT_TRUE(kept.losses.empty());
    EXPECT_EQ(kept.lut.interpolation, Interpolation::trilinear);
    lut.interpolation = Interpolation::tetrahedral;
    EXPECT_TRUE(fit_to(lut, Holds{.cube = true}).losses.empty());
}

TEST(FitTo, leaves_a_look_alone_that_the_format_can_hold) {
    for (const auto& [name, lut] : looks_of_every_shape()) {
        for (const FileFormat* const format : file_formats()) {
            if (format->write && can_hold(lut, format->holds) && format->holds.integer_bits == 0) {
                const FitToFormat fit = fit_to(lut, format->holds);
                EXPECT_EQ(fit.lut.shaper, lut.shaper) << format->name << ' ' << name;
                EXPECT_EQ(fit.lut.cube, lut.cube) << format->name << ' ' << name;
            }
        }
    }
}

} // namespace
} // namespace lutlib::io
