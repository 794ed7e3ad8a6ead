#include "lutlib/recipe/placement.h"

#include "lutlib/engine/engine.h"
#include "lutlib/recipe/recipe.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lutlib {
namespace {

const Encoding logc3 = *encoding_named("logc3"), slog3 = *encoding_named("slog3/rec709");

// The published formulas, by hand: IEC 61966-2-1, and ARRI's "ALEXA Log C Curve" for EI 800.
double linear_of_srgb(double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
double logc3_of_linear(double x) {
    return x > 0.010591 ? 0.247190 * std::log10(5.555556 * x + 0.052272) + 0.385537
                        : 5.367655 * x + 0.092809;
}

TEST(Placement, converts_a_grey_by_the_two_published_curves) {
    const Transform convert = conversion({srgb(), logc3});
    for (int i = 0; i <= 100; ++i) {
        const double v = i / 100.0, wanted = logc3_of_linear(linear_of_srgb(v));
        const RgbD got = convert(RgbD{v, v, v});
        EXPECT_NEAR(got.r, wanted, 2e-6);
        EXPECT_NEAR(got.g, wanted, 2e-6);
        EXPECT_NEAR(got.b, wanted, 2e-6);
    }
}

TEST(Placement, goes_around_a_look_in_both_encodings_and_back) {
    // Nothing is changed in log light, so nothing is changed in codes.
    const LookPlace place{{logc3, logc3}, srgb(), srgb()};
    const Transform around = place.applied().around(Transform{});
    for (const Rgb& in : identity_cube(9).nodes) {
        const RgbD out = around(to_double(in));
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(out[c], in[c], 1e-9);
        }
    }
    EXPECT_EQ(place.shown(), (LookEncodings{srgb(), srgb()}));
}

TEST(Placement, converts_only_what_is_known_and_differs) {
    const LookPlace input_alone{{logc3, {}}, srgb(), srgb()};
    EXPECT_TRUE(input_alone.applied().before && !input_alone.applied().after);
    EXPECT_TRUE(input_alone.is_unknown());
    const LookPlace same{{srgb(), encoding_named("srgb/rec709")}, srgb(), srgb()};
    EXPECT_FALSE(same.applied().converts() || same.is_unknown() || same.is_wrong());
    const LookPlace anywhere{{logc3, slog3}, {}, {}};
    EXPECT_FALSE(anywhere.applied().converts() || anywhere.is_unknown());
    EXPECT_EQ(sentence_of(anywhere, "hald"),
              "the look takes logc3 and gives slog3/rec709: give it that in hald");
    EXPECT_EQ(sentence_of({}, "hald"), "");
}

TEST(Placement, left_alone_is_wrong_where_the_encodings_differ) {
    LookPlace place{{logc3, srgb()}, srgb(), srgb(), false};
    EXPECT_FALSE(place.applied().converts());
    EXPECT_TRUE(place.is_wrong());
    EXPECT_EQ(sentence_of(place, "unity"),
              "the look is left as it is, though it takes logc3 and unity feeds it srgb");
    place.look = {srgb(), srgb()};
    EXPECT_FALSE(place.is_wrong());
}

TEST(Placement, says_what_it_does_and_what_it_does_not_know) {
    EXPECT_EQ(sentence_of({{logc3, slog3}, srgb(), srgb()}, "unity"),
              "srgb is converted to logc3 before the look, and slog3/rec709 to srgb after it");
    EXPECT_EQ(sentence_of({{{}, {}}, srgb(), srgb()}, "unity"),
              "the look's encodings are not known and taken for srgb, which unity feeds: if they "
              "are others, name them with --look-input and --look-output");
    EXPECT_EQ(sentence_of({{slog3, {}}, logc3, srgb()}, "the picture"),
              "logc3 is converted to slog3/rec709 before the look; the look's output encoding is "
              "not known and taken for srgb: if it is another, name it with --look-output");
    EXPECT_EQ(sentence_of({{srgb(), slog3}, srgb(), {}}, "the picture"),
              "the look takes srgb and gives slog3/rec709, as the picture does");
    EXPECT_EQ(sentence_of({{srgb(), srgb()}, srgb(), srgb()}, "unity"),
              "the look takes and gives srgb, as unity does");
}

TEST(Placement, bounds_what_the_look_is_fed) {
    const LookPlace place{{logc3, logc3}, srgb(), srgb()};
    const Domain fed = place.applied().fed();
    const Transform convert = conversion({srgb(), logc3});
    for (const Rgb& in : identity_cube(17).nodes) {
        const Rgb code = to_float(convert(to_double(in)));
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_GE(code[c], fed.min[c]);
            EXPECT_LE(code[c], fed.max[c]);
        }
    }
    EXPECT_NEAR(fed.max.r, logc3_of_linear(1), 1e-5);
    EXPECT_TRUE(Placement{}.fed().is_unit());
}

TEST(Placement, of_a_recipe_over_a_base_that_says_nothing_is_unknown) {
    Recipe recipe;
    EXPECT_EQ(encodings_of(recipe), (LookEncodings{srgb(), srgb()}));
    Lut base;
    base.cube = identity_cube(2);
    recipe.base_lut = std::make_shared<const Lut>(base);
    EXPECT_EQ(encodings_of(recipe), (LookEncodings{}));
    recipe.output = slog3;
    EXPECT_EQ(encodings_of(recipe), (LookEncodings{{}, slog3}));
    base.encodings = {"logc3", "srgb"};
    recipe.output.reset();
    recipe.base_lut = std::make_shared<const Lut>(base);
    EXPECT_EQ(encodings_of(recipe), (LookEncodings{logc3, srgb()}));
}

TEST(EncodingOfEngines, is_a_known_encoding_or_left_to_the_look) {
    for (const Engine& engine : engines()) {
        EXPECT_TRUE(engine.encoding.empty() || encoding_named(engine.encoding)) << engine.name;
    }
    EXPECT_EQ(encoding_fed_through(*layout_named("strip")), "srgb");
    EXPECT_EQ(encoding_fed_through(*layout_named("hald")), "");
}

} // namespace
} // namespace lutlib
