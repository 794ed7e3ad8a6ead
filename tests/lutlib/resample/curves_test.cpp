// Curves stay curves: resampled, composed, blended and inverted 1D tables.
#include "lutlib/resample/curves.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/resample/combine.h"
#include "lutlib/resample/invert.h"
#include "lutlib/resample/resample.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lutlib {
namespace {

const ResamplingMethod& tetrahedral() {
    return *resampling_method_named("tetrahedral");
}

template <class F>
Lut curve(int size, const Domain& domain, F f) {
    Lut out;
    out.shaper = Lut1D{domain, std::vector<Rgb>(static_cast<std::size_t>(size))};
    for (int i = 0; i < size; ++i) {
        const RgbD x = entry_position(*out.shaper, i);
        out.shaper->entries[static_cast<std::size_t>(i)] = to_float({f(x.r), f(x.g), f(x.b)});
    }
    return out;
}

constexpr Domain hdr{{0, 0, 0}, {16, 16, 16}};

double log_curve(double x) {
    return std::log2(1 + 63 * x) / 10;
}

double largest_difference(const Lut& lut, const std::vector<Rgb>& inputs, auto wanted) {
    double most = 0;
    for (const Rgb& in : inputs) {
        most = std::max(
            most, largest_magnitude(evaluate_exact(lut, to_double(in)) - wanted(to_double(in))));
    }
    return most;
}

TEST(Curves, are_resampled_to_any_number_of_entries_and_to_their_own_to_the_bit) {
    const Lut look = curve(30, {}, [](double x) { return std::pow(x, 0.45); });
    Sampling sampling;
    EXPECT_EQ(resample(look, sampling, tetrahedral()).shaper, look.shaper);
    sampling.size = 4096;
    const Lut fine = resample(look, sampling, tetrahedral());
    EXPECT_FALSE(fine.cube);
    EXPECT_EQ(fine.shaper->size(), 4096);
    const auto exact = [&](RgbD in) { return evaluate_exact(look, in); };
    EXPECT_LT(largest_difference(fine, samples_over({}, 9, 2000), exact), 2e-4);
    sampling.domain = Domain{{0, 0, 0}, {.5F, .5F, .5F}};
    EXPECT_EQ(resample(look, sampling, tetrahedral()).domain(), *sampling.domain);
    sampling.size = 9;
    sampling.shaper = "none";
    EXPECT_TRUE(resample(look, sampling, tetrahedral()).cube)
        << "a cube is made where it is asked for";
}

TEST(Curves, composed_and_blended_are_curves_as_close_as_their_tolerance) {
    const Lut a = curve(4096, hdr, log_curve);
    const Lut b = curve(30, {}, [](double x) { return x * x * (3 - 2 * x); });
    const auto composed = [&](RgbD in) { return evaluate_exact(b, evaluate_exact(a, in)); };
    const Lut both = compose({&a, &b}, {}, tetrahedral());
    ASSERT_FALSE(both.cube);
    EXPECT_EQ(both.domain(), hdr);
    EXPECT_LT(largest_difference(both, samples_over(hdr, 9, 5000), composed), 2 * curve_tolerance);
    const auto mixed = [&](RgbD in) {
        return evaluate_exact(a, in) * .25 + evaluate_exact(b, in) * .75;
    };
    const Lut blended = blend(a, b, .75, {}, tetrahedral());
    ASSERT_FALSE(blended.cube);
    EXPECT_EQ(blended.domain(), hdr);
    EXPECT_LT(largest_difference(blended, samples_over(hdr, 9, 5000), mixed), 2 * curve_tolerance);
    const Lut half = blend({}, b, .5, {}, tetrahedral());
    ASSERT_FALSE(half.cube) << "the identity mixes nothing";
    EXPECT_NEAR(evaluate_exact(half, {.5, .5, .5}).g, .5, 1e-3);
}

TEST(Curves, blended_with_a_cube_shape_its_input_and_keep_their_own_bend) {
    const Lut a = curve(4096, hdr, log_curve);
    Lut b;
    b.cube = sampled([](RgbD c) { return RgbD{c.g, c.r, c.b}; }, 17);
    const Lut out = blend(a, b, 0, {}, tetrahedral());
    ASSERT_TRUE(out.shaper && out.cube);
    const auto exact = [&](RgbD in) { return evaluate_exact(a, in); };
    EXPECT_LT(largest_difference(out, samples_over(hdr, 17, 5000), exact), 1e-4);
}

TEST(Blend, with_the_identity_keeps_a_looks_domain) {
    Lut look;
    look.cube = identity_cube(9, {{0, 0, 0}, {4, 4, 4}});
    EXPECT_EQ(blend({}, look, 1, {}, tetrahedral()).domain(), look.domain());
}

TEST(InvertCurve, undoes_a_log_curve_over_its_whole_range) {
    const Lut look = curve(4096, hdr, log_curve);
    const Inversion out = invert(look);
    ASSERT_TRUE(out.lut.shaper && !out.lut.cube && out.curve);
    EXPECT_EQ(out.lut.domain().max, look.shaper->entries.back());
    for (const double x : {0.0, 0.001, 0.18, 1.0, 7.3, 16.0}) {
        const RgbD y = evaluate_exact(look, {x, x, x});
        EXPECT_NEAR(evaluate_exact(out.lut, y).g, x, 2e-5) << x;
    }
    // d/dx log2(1 + 63 x) / 10 = 6.3 / ln 2 / (1 + 63 x)
    const auto& red = (*out.curve)[0];
    EXPECT_NEAR(red.slope_low, std::log(2.0) / 6.3, 0.02);
    EXPECT_NEAR(red.slope_high, std::log(2.0) / 6.3 * 1009, 0.5);
    EXPECT_EQ(red.flat + red.turned, 0);
}

TEST(InvertCurve, of_a_falling_curve_falls) {
    const Lut look = curve(100, {}, [](double x) { return 2 - x * (1 + x); });
    const Inversion out = invert(look);
    EXPECT_EQ(out.lut.domain(), (Domain{{0, 0, 0}, {2, 2, 2}}));
    for (const double x : {0.0, 0.3, 0.77, 1.0}) {
        EXPECT_NEAR(evaluate_exact(out.lut, evaluate_exact(look, {x, x, x})).r, x, 2e-6);
    }
}

TEST(InvertCurve, gives_a_clipped_white_back_as_white_and_tells_the_flat_part) {
    const Lut look = curve(101, {}, [](double x) { return std::min(1.0, x / .8); });
    const Inversion out = invert(look);
    EXPECT_NEAR((*out.curve)[1].flat, .2, 1e-6);
    EXPECT_EQ((*out.curve)[1].turned, 0);
    EXPECT_EQ(evaluate_exact(out.lut, {1, 1, 1}), (RgbD{1, 1, 1}));
    EXPECT_NEAR(evaluate_exact(out.lut, {.99, .99, .99}).g, .792, 1e-3);
    EXPECT_NEAR((*out.curve)[1].slope_high, .8, 1e-6);
}

TEST(InvertCurve, takes_the_first_of_several_inputs_where_the_curve_turns_back) {
    // Rises to 0.6 at 0.5, falls to 0.4 at 0.7, rises to 1.
    const Lut look = curve(1001, {}, [](double x) {
        return x < .5 ? 1.2 * x : x < .7 ? .6 - (x - .5) : .4 + 2 * (x - .7);
    });
    const Inversion out = invert(look);
    EXPECT_NEAR((*out.curve)[2].turned, .3, 2e-3);
    EXPECT_NEAR((*out.curve)[2].depth, .2, 1e-6);
    EXPECT_NEAR(evaluate_exact(out.lut, {.5, .5, .5}).b, .5 / 1.2, 1e-5);
    EXPECT_NEAR(evaluate_exact(out.lut, {.8, .8, .8}).b, .9, 1e-5);
    for (std::size_t i = 1; i < out.lut.shaper->entries.size(); ++i) {
        EXPECT_GE(out.lut.shaper->entries[i].b, out.lut.shaper->entries[i - 1].b) << "monotone";
    }
}

TEST(InvertCurve, has_the_entries_and_the_domain_that_are_asked_for) {
    const Lut look = curve(30, {}, [](double x) { return .25 + .5 * x; });
    InvertOptions options;
    options.size = 5;
    options.domain = Domain{};
    const Inversion out = invert(look, options);
    EXPECT_EQ(out.lut.shaper->size(), 5);
    EXPECT_EQ(out.lut.shaper->entries[0], (Rgb{0, 0, 0}));
    EXPECT_FLOAT_EQ(out.lut.shaper->entries[2].r, .5F);
    EXPECT_EQ(out.lut.shaper->entries[4], (Rgb{1, 1, 1}));
}

TEST(InvertCurve, refuses_a_channel_without_direction) {
    EXPECT_THROW(invert(curve(5, {}, [](double) { return .5; })), Error);
    EXPECT_THROW(invert(curve(5, {}, [](double x) { return x * (1 - x); })), Error);
}

} // namespace
} // namespace lutlib
