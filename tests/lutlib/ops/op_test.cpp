#include "lutlib/ops/op.h"

#include "lutlib/color/encoding.h"
#include "lutlib/color/oklab.h"
#include "lutlib/error.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/transform.h"
#include "tests/lutlib/ops/op_samples.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>

namespace lutlib {
namespace {

using support::test_name;
using test::extreme_operation;
using test::many_colors;
using test::some_operation;

class EveryOperator : public testing::TestWithParam<const Op*> {};
INSTANTIATE_TEST_SUITE_P(Op, EveryOperator, testing::ValuesIn(ops().begin(), ops().end()),
                         [](const auto& row) { return test_name(row.param->name); });

Transform edit_of(const Operation& operation, const Encoding& encoding = srgb()) {
    Recipe recipe;
    recipe.input = encoding;
    recipe.operations = {operation};
    return Transform::of(recipe);
}

RgbD srgb_of(RgbD oklab) {
    const RgbD c = linear_from_oklab(oklab);
    return {srgb().encode(c.r), srgb().encode(c.g), srgb().encode(c.b)};
}

RgbD at_hue(double dial, double chroma) {
    const double t = oklab_hue(dial) * std::numbers::pi / 180;
    return srgb_of({0.6, chroma * std::cos(t), chroma * std::sin(t)});
}

TEST_P(EveryOperator, is_exactly_the_identity_at_its_defaults) {
    const Operation operation = default_operation(*GetParam());
    EXPECT_TRUE(is_identity(operation));
    const std::vector<RgbD> before = many_colors(100000);
    // The operator itself, in its own space, and the recipe around it.
    std::vector<RgbD> own = before, recipe = before;
    GetParam()->compile(operation.values, {})(own);
    edit_of(operation)(recipe);
    for (std::size_t i = 0; i < before.size(); ++i) {
        ASSERT_EQ(own[i], before[i]) << i;
        ASSERT_EQ(recipe[i], before[i]) << i;
    }
}

TEST_P(EveryOperator, is_finite_on_every_finite_color_in_every_encoding) {
    std::mt19937 random(1);
    const std::vector<RgbD> before = many_colors(16000);
    for (const Encoding& encoding : encodings()) {
        for (const Operation& operation :
             {extreme_operation(*GetParam(), false), extreme_operation(*GetParam(), true),
              some_operation(*GetParam(), random)}) {
            std::vector<RgbD> colors = before;
            edit_of(operation, encoding)(colors);
            for (std::size_t i = 0; i < before.size(); ++i) {
                ASSERT_TRUE(std::isfinite(colors[i].r) && std::isfinite(colors[i].g) &&
                            std::isfinite(colors[i].b))
                    << encoding.name() << ' ' << before[i].r << ' ' << before[i].g << ' '
                    << before[i].b;
            }
        }
    }
}

TEST_P(EveryOperator, answers_nan_as_it_answers_zero) {
    std::mt19937 random(2);
    const Transform edit = edit_of(some_operation(*GetParam(), random));
    EXPECT_EQ(edit({NAN, .5, NAN}), edit({0, .5, 0}));
    EXPECT_TRUE(std::isfinite(largest_magnitude(edit({INFINITY, -INFINITY, NAN}))));
}

// The slope of an operator between two near colours may be steep, but not infinite: a seam would
// give step / distance, which grows without bound as the distance falls.
TEST_P(EveryOperator, has_no_seam_at_hue_0_at_other_hues_or_at_neutral) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int round = 0; round < 40; ++round) {
        const Operation operation = some_operation(*GetParam(), random);
        const Transform edit = edit_of(operation);
        const auto slope = [&](RgbD a, RgbD b) {
            return largest_magnitude(edit(a) - edit(b)) / largest_magnitude(a - b);
        };
        // The steepest that the parameters allow on these mid-tones: exposure by 10 stops gives
        // 1024 in light, powers of 10 and curves of 17 units within a few hundredths the like.
        constexpr double steepest = 1e5;
        for (int i = 0; i < 60; ++i) {
            const double grey = 0.2 + 0.6 * unit(random), chroma = 0.01 + 0.1 * unit(random);
            // Across the dial's zero and the other places where its formula changes, across the
            // neutral axis, and anywhere.
            for (const double hue : {0.0, 60.0, 120.0, 180.0, 240.0, 300.0, 17.0}) {
                EXPECT_LT(slope(at_hue(hue - 1e-7, chroma), at_hue(hue + 1e-7, chroma)), steepest);
            }
            const RgbD step{1e-9 * (unit(random) - 0.5), 1e-9 * (unit(random) - 0.5), 5e-10};
            const RgbD neutral{grey, grey, grey};
            EXPECT_LT(slope(neutral + step, neutral - step), steepest);
            const RgbD any{0.1 + unit(random) * .8, 0.1 + unit(random) * .8,
                           0.1 + unit(random) * .8};
            EXPECT_LT(slope(any, any + step), steepest);
        }
        // Across Oklab's axes, where the dial's formula changes.
        for (double c = 0.001; c < 0.1; c *= 1.5) {
            for (const auto& [a, b] : {std::pair{-c, 0.0}, {c, 0.0}, {0.0, c}, {0.0, -c}}) {
                const double e = 1e-9;
                EXPECT_LT(slope(srgb_of({0.6, a + e, b + e}), srgb_of({0.6, a - e, b - e})),
                          steepest);
            }
        }
    }
}

std::vector<const Op*> monotone_ops() {
    std::vector<const Op*> out;
    std::copy_if(ops().begin(), ops().end(), std::back_inserter(out),
                 [](const Op* op) { return op->monotone_on_neutrals; });
    return out;
}

class EveryMonotoneOperator : public testing::TestWithParam<const Op*> {};
INSTANTIATE_TEST_SUITE_P(Op, EveryMonotoneOperator, testing::ValuesIn(monotone_ops()),
                         [](const auto& row) { return test_name(row.param->name); });

TEST_P(EveryMonotoneOperator, keeps_rising_neutrals_rising) {
    std::mt19937 random(4);
    for (int round = 0; round < 50; ++round) {
        const Transform edit = edit_of(some_operation(*GetParam(), random));
        RgbD before = edit({0, 0, 0});
        for (int i = 1; i <= 1000; ++i) {
            const double v = i / 1000.0;
            const RgbD now = edit({v, v, v});
            // Room for the rounding of the way to Oklab and back, and for the published constants
            // of sRGB, whose segments meet within 1e-7.
            for (std::size_t c = 0; c < 3; ++c) {
                ASSERT_GE(now[c], before[c] - 1e-6 * (1 + std::abs(before[c])));
            }
            before = now;
        }
    }
}

TEST_P(EveryOperator, describes_itself_wholly) {
    const Op& op = *GetParam();
    EXPECT_EQ(op_named(op.name), &op);
    EXPECT_FALSE(op.label.empty() || op.help.empty() || op.reference.empty());
    ASSERT_FALSE(op.parameters.empty());
    for (const Parameter& parameter : op.parameters) {
        EXPECT_FALSE(parameter.name.empty() || parameter.flag.empty() || parameter.label.empty());
        EXPECT_LT(parameter.min, parameter.max);
        EXPECT_EQ(problem_with(parameter, default_value(parameter)), "");
    }
}

TEST_P(EveryOperator, reads_its_values_back_from_their_text) {
    std::mt19937 random(5);
    const Operation operation = some_operation(*GetParam(), random);
    for (std::size_t i = 0; i < operation.values.size(); ++i) {
        EXPECT_EQ(parse_value(operation.op->parameters[i], value_text(operation.values[i])),
                  operation.values[i]);
    }
}

TEST_P(EveryOperator, refuses_text_that_is_no_value_of_its_parameters) {
    for (const Parameter& parameter : GetParam()->parameters) {
        for (const char* text : {"", "x", "nan", "inf", "1e9", "1:2:3", "1,2", "0.5 0.5", "--1"}) {
            EXPECT_THROW(parse_value(parameter, text), UsageError) << parameter.flag << ' ' << text;
        }
    }
}

TEST(Ops, have_names_and_flags_of_their_own) {
    std::set<std::string_view> names, flags;
    std::size_t parameters = 0;
    for (const Op* op : ops()) {
        names.insert(op->name);
        for (const Parameter& parameter : op->parameters) {
            flags.insert(parameter.flag);
            ++parameters;
        }
    }
    EXPECT_EQ(names.size(), ops().size());
    EXPECT_EQ(flags.size(), parameters);
}

} // namespace
} // namespace lutlib
