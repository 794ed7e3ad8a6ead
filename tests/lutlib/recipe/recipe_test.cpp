#include "lutlib/recipe/recipe.h"

#include "lutlib/error.h"
#include "tests/lutlib/ops/op_samples.h"

#include <gtest/gtest.h>

namespace lutlib {
namespace {

Recipe full_recipe() {
    std::mt19937 random(1);
    Recipe recipe;
    recipe.title = "Everything, \"quoted\" and \xc3\xa9";
    recipe.input = require_encoding("logc3/ap1");
    recipe.output = require_encoding("srgb");
    recipe.base = "some look.cube";
    recipe.opacity = 0.8;
    recipe.bake = {48, Domain{{-.1F, 0, 0}, {4, 3.5F, 1}}, "tone", 777};
    for (const Op* op : ops()) {
        Operation operation = test::some_operation(*op, random);
        operation.enabled = recipe.operations.size() % 3 != 1;
        operation.opacity = recipe.operations.size() % 4 == 0 ? 0.35 : 1;
        recipe.operations.push_back(operation);
        recipe.operations.push_back(default_operation(*op));
    }
    return recipe;
}

TEST(Recipe, comes_back_from_json_with_every_operator_and_every_bit) {
    const Recipe before = full_recipe();
    const std::string text = to_json(before);
    const Recipe after = parse_recipe(text, "r.json");
    EXPECT_EQ(after.title, before.title);
    EXPECT_EQ(after.input, before.input);
    EXPECT_EQ(after.output, before.output);
    EXPECT_EQ(after.base, before.base);
    EXPECT_EQ(after.bake, before.bake);
    EXPECT_EQ(after.operations, before.operations);
    EXPECT_EQ(after.opacity, before.opacity);
    EXPECT_EQ(to_json(after), text);
}

TEST(Recipe, leaves_defaults_out_and_puts_one_operator_on_a_line) {
    Recipe recipe;
    recipe.operations.push_back(default_operation(*op_named("saturation")));
    recipe.operations.back().values[0] = 1.3;
    recipe.operations.push_back(default_operation(*op_named("hue-vs-sat")));
    recipe.operations.back().values[0] = Knots{{0, 1}, {120, 1.4}};
    recipe.operations.push_back(default_operation(*op_named("contrast")));
    EXPECT_EQ(to_json(recipe), R"({
  "schema_version": 1,
  "input": "srgb",
  "operators": [
    {"op": "saturation", "amount": 1.3},
    {"op": "hue-vs-sat", "curve": [[0, 1], [120, 1.4]]},
    {"op": "contrast"}
  ]
}
)");
}

TEST(Recipe, takes_one_number_for_three_channels_and_a_toggle_as_its_flag_does) {
    const auto values = [](const std::string& fields) {
        return parse_recipe(R"({"schema_version": 1, "operators": [{"op": )" + fields + "}]}", "")
            .operations.front()
            .values;
    };
    EXPECT_EQ(values(R"("lift-gamma-gain", "gamma": 1.2)"),
              values(R"("lift-gamma-gain", "gamma": [1.2, 1.2, 1.2])"));
    EXPECT_EQ(values(R"("cdl", "clamp": "on")"), values(R"("cdl", "clamp": true)"));
    EXPECT_EQ(values(R"("cdl", "clamp": 0)"), values(R"("cdl", "clamp": false)"));
}

TEST(Recipe, keeps_the_knots_at_both_ends_of_a_circle_where_they_agree) {
    const Recipe recipe = parse_recipe(R"({"schema_version": 1, "operators": [
        {"op": "hue-vs-sat", "curve": [[0, 1.2], [180, 1], [360, 1.2]]}]})",
                                       "");
    EXPECT_EQ(std::get<Knots>(recipe.operations.front().values[0]).size(), 3U);
}

struct BadRecipe {
    const char* name;
    const char* text;
    const char* message; // a part of it
};

const BadRecipe bad_recipes[] = {
    {"broken_json", "{\n \"schema_version\": 1,\n oops\n}", "r.json:3: this is not JSON: ' oops'"},
    {"no_object", "[]", "the recipe must be an object"},
    {"no_version", "{}", "lacks \"schema_version\": 1"},
    {"later_version", R"({"schema_version": 2})", "schema_version is 2; this program reads"},
    {"unknown_key", R"({"schema_version": 1, "opperators": []})", "unknown key 'opperators'"},
    {"unknown_encoding", R"({"schema_version": 1, "input": "slog9"})",
     "input is wrong: there is no curve 'slog9'"},
    {"unknown_operator", R"({"schema_version": 1, "operators": [{"op": "offset"}, {"op": "x"}]})",
     "operators[1].op is 'x'; there are exposure"},
    {"operator_without_name", R"({"schema_version": 1, "operators": [{"amount": 1}]})",
     "operators[0] lacks its \"op\""},
    {"unknown_parameter",
     R"({"schema_version": 1, "operators": [{"op": "saturation", "amonut": 1}]})",
     "operators[0] has an unknown key 'amonut'; did you mean amount? There are op, enabled, "
     "opacity, amount"},
    {"out_of_range", R"({"schema_version": 1, "operators": [{"op": "saturation", "amount": 7}]})",
     "operators[0].amount is 7; the range is 0 to 4"},
    {"opacity_out_of_range",
     R"({"schema_version": 1, "operators": [{"op": "saturation", "opacity": 1.5}]})",
     "operators[0].opacity is 1.5; the range is 0 to 1"},
    {"opacity_of_the_look_as_text", R"({"schema_version": 1, "opacity": "half"})",
     "opacity must be a number"},
    {"channel_out_of_range",
     R"({"schema_version": 1, "operators": [{"op": "offset", "amount": [0, 3, 0]}]})",
     "operators[0].amount is 3; the range is -1 to 1"},
    {"two_channels", R"({"schema_version": 1, "operators": [{"op": "offset", "amount": [0, 3]}]})",
     "operators[0].amount must be a number or a list of 3"},
    {"text_for_number",
     R"({"schema_version": 1, "operators": [{"op": "saturation", "amount": "1"}]})",
     "operators[0].amount must be a number"},
    {"knot_of_three",
     R"({"schema_version": 1, "operators": [{"op": "hue-vs-sat", "curve": [[0, 1], [1, 2, 3]]}]})",
     "operators[0].curve[1] must be a list of 2"},
    {"knot_out_of_range",
     R"({"schema_version": 1, "operators": [{"op": "hue-vs-sat", "curve": [[400, 1]]}]})",
     "operators[0].curve has a knot whose hue is 400; the range is 0 to 360"},
    {"toggle_as_other_number", R"({"schema_version": 1, "operators": [{"op": "cdl", "clamp": 2}]})",
     "operators[0].clamp must be true or false"},
    {"hue_of_two_values",
     R"({"schema_version": 1, "operators": [{"op": "hue-vs-sat", "curve": [[0, 1], [360, 2]]}]})",
     "operators[0].curve has two values at one hue: 1 at 0 and 2 at 360; keep one of them"},
    {"size_too_large", R"({"schema_version": 1, "bake": {"size": 1000}})",
     "bake.size must be a whole number from 2 to 256"},
    {"inverted_domain", R"({"schema_version": 1, "bake": {"domain": [1, 0]}})",
     "bake.domain cannot be"},
    {"unknown_shaper", R"({"schema_version": 1, "bake": {"shaper": "steep"}})",
     "bake.shaper is 'steep'; there are tone, none"},
    {"huge_number", R"({"schema_version": 1, "operators": [{"op": "exposure", "stops": 1e999}]})",
     "r.json: this JSON cannot be read"},
};

class BadRecipes : public testing::TestWithParam<BadRecipe> {};
INSTANTIATE_TEST_SUITE_P(Recipe, BadRecipes, testing::ValuesIn(bad_recipes),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(BadRecipes, are_refused_with_the_place_and_the_reason) {
    try {
        parse_recipe(GetParam().text, "r.json");
        FAIL() << "was read";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(GetParam().message), std::string::npos)
            << error.what();
        EXPECT_EQ(error.where().file, "r.json");
    }
}

} // namespace
} // namespace lutlib
