// The verbs that make LUTs of LUTs and recipes.
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

namespace converter_test {
namespace {

using nlohmann::json;

json run(const std::vector<std::string>& arguments) {
    std::vector<std::string> all = arguments;
    all.emplace_back("--json");
    const Result result = lutconv(all);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? json::parse(result.out) : json();
}

std::string color_at(const std::string& lut, const char* r, const char* g, const char* b) {
    return lutconv({"eval", lut, r, g, b}).out;
}

TEST(Edit, without_operators_is_the_identity_to_the_bit) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(9));
    run({"edit", "identity", "-o", folder.path("i.cube")});
    EXPECT_EQ(run({"compare", "identity", folder.path("i.cube")})["absolute"]["max"], 0);
    run({"edit", look, "-o", folder.path("same.cube"), "--saturation", "1"});
    EXPECT_EQ(run({"compare", look, folder.path("same.cube")})["absolute"]["max"], 0);
}

TEST(Edit, applies_operators_in_the_order_of_their_flags_and_groups_one_operators_flags) {
    const Folder folder;
    const auto edited = [&](std::vector<std::string> flags) {
        flags.insert(flags.begin(), {"edit", "identity", "-o", folder.path("x.cube"),
                                     "--save-recipe", folder.path("x.json")});
        run(flags);
        return json::parse(contents(folder.path("x.json")))["operators"];
    };
    const json a = edited(
        {"--contrast", "1.5", "--contrast-pivot", "0", "--offset", "0.1", "--contrast", "0.5"});
    ASSERT_EQ(a.size(), 3U);
    EXPECT_EQ(a[0], json({{"op", "contrast"}, {"amount", 1.5}, {"pivot", 0}}));
    EXPECT_EQ(a[1], json({{"op", "offset"}, {"amount", {.1, .1, .1}}}));
    EXPECT_EQ(a[2], json({{"op", "contrast"}, {"amount", 0.5}}));
    const json b = edited({"--offset", "-0.1, 0, 0.2", "--hue-vs-sat", "0:1, 120:1.4, 240:0.8"});
    EXPECT_EQ(b[0]["amount"], json({-.1, 0, .2}));
    EXPECT_EQ(b[1], json({{"op", "hue-vs-sat"}, {"curve", {{0, 1}, {120, 1.4}, {240, .8}}}}));
}

TEST(Edit, gives_values_that_can_be_worked_out_by_hand) {
    const Folder folder;
    const std::string out = folder.path("x.cube");
    run({"edit", "identity", "-o", out, "--size", "5", "--contrast", "2", "--contrast-pivot",
         "0.25", "--offset", "0.125,0,0"});
    EXPECT_EQ(color_at(out, "0.5", "0.25", "0"), "0.875 0.25 -0.25\n");
    run({"edit", "identity", "-o", out, "--size", "2", "--saturation", "0"});
    EXPECT_EQ(color_at(out, "0", "1", "0").substr(0, 6), "0.7152");
}

TEST(Edit, takes_a_part_of_the_operator_before_it_and_of_the_whole_look) {
    const Folder folder;
    const std::string out = folder.path("x.cube"), recipe = folder.path("x.json");
    run({"edit", "identity", "-o", out, "--size", "5", "--offset", "0.5", "--opacity", "0.5",
         "--contrast", "2", "--contrast-pivot", "0", "--save-recipe", recipe});
    EXPECT_EQ(color_at(out, "0.25", "0.5", "0"), "1 1.5 0.5\n");
    EXPECT_EQ(json::parse(contents(recipe))["operators"][0]["opacity"], 0.5);
    run({"edit", recipe, "-o", out, "--look-opacity", "0.5", "--save-recipe", recipe, "--force"});
    EXPECT_EQ(color_at(out, "0.25", "0.5", "0"), "0.625 1 0.25\n");
    EXPECT_EQ(json::parse(contents(recipe))["opacity"], 0.5);
    run({"edit", recipe, "-o", out, "--look-opacity", "1"});
    EXPECT_EQ(color_at(out, "0.25", "0.5", "0"), "1 1.5 0.5\n");
    const Result alone = lutconv({"edit", "identity", "-o", out, "--opacity", "0.5"});
    EXPECT_EQ(alone.exit_code, 3);
    EXPECT_NE(alone.err.find("--opacity belongs to the operator before it"), std::string::npos);
    EXPECT_EQ(lutconv({"edit", "identity", "-o", out, "--offset", "1", "--opacity", "2"}).exit_code,
              3);
}

TEST(Edit, keeps_a_recipe_with_its_base_that_bakes_to_the_same_lut) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(9));
    std::filesystem::create_directory(folder.path("recipes"));
    const std::string recipe = folder.path("recipes/a.json");
    run({"edit", look, "-o", folder.path("one.cube"), "--exposure", "0.5", "--vibrance", "0.3",
         "--save-recipe", recipe});
    EXPECT_EQ(json::parse(contents(recipe))["base"], "../a.cube");
    run({"edit", "--recipe", recipe, "-o", folder.path("two.cube"), "--allow-outside"});
    EXPECT_EQ(contents(folder.path("one.cube")), contents(folder.path("two.cube")));
    const Result baked =
        lutconv({"bake", recipe, "-o", folder.path("a.png"), "--measure", "--allow-outside"});
    EXPECT_EQ(baked.exit_code, 0) << baked.err;
    EXPECT_NE(baked.out.find("dE2000: p99"), std::string::npos) << baked.out;
}

TEST(Edit, says_when_the_base_of_its_recipe_lies_where_opening_it_needs_a_word) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(5));
    std::filesystem::create_directory(folder.path("recipes"));
    const std::string inside = folder.path("a.json"), outside = folder.path("recipes/a.json");
    EXPECT_EQ(lutconv({"edit", look, "--save-recipe", inside}).err, "");
    const Result saved = lutconv({"edit", look, "--save-recipe", outside});
    EXPECT_EQ(saved.exit_code, 0);
    EXPECT_NE(saved.err.find("who opens it must add --allow-outside"), std::string::npos)
        << saved.err;
    EXPECT_EQ(lutconv({"info", inside}).exit_code, 0);
    const Result refused = lutconv({"info", outside});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find("a.cube: it lies outside the folder of " + outside),
              std::string::npos)
        << refused.err;
    EXPECT_EQ(lutconv({"info", outside, "--allow-outside"}).exit_code, 0);
}

TEST(Edit, writes_the_lut_and_the_recipe_or_neither) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(5)),
                      recipe = folder.write("r.json", "as it was"), lut = folder.path("x.cube");
    const auto edited = [&](const std::string& to, const std::string& recipe_to) {
        return lutconv(
            {"edit", look, "--exposure", "1", "-o", to, "--save-recipe", recipe_to, "--force"});
    };
    for (const std::string& to : {folder.path("none/x.cube"), folder.path("x.unknown"),
                                  std::string("/dev/full"), folder.path(".")}) {
        EXPECT_NE(edited(to, recipe).exit_code, 0) << to;
        EXPECT_EQ(contents(recipe), "as it was") << to;
    }
    EXPECT_EQ(edited(lut, folder.path("none/r.json")).exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(lut));
    EXPECT_EQ(edited(lut, recipe).exit_code, 0);
    EXPECT_EQ(json::parse(contents(recipe))["base"], "a.cube");
    EXPECT_EQ(folder.names().size(), 3U);
}

TEST(Outputs, of_one_name_are_refused_by_any_of_its_paths) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(3));
    const std::string file = folder.path("x.cube"), same = folder.path("./x.cube"),
                      link = folder.path("link.cube");
    std::filesystem::create_symlink("x.cube", link);
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"edit", look, "-o", file, "--save-recipe", file},
             {"edit", look, "-o", file, "--save-recipe", same},
             {"edit", look, "-o", file, "--save-recipe", link},
             {"report", look, "-o", file, "--json", same},
             {"report", look, "-o", file, "--csv", folder.path("y"), "--json", folder.path("y")}}) {
        const Result result = lutconv(words);
        EXPECT_EQ(result.exit_code, 3) << result.err;
        EXPECT_NE(result.err.find("two outputs would be written to"), std::string::npos)
            << result.err;
    }
    EXPECT_EQ(folder.names().size(), 2U);
}

TEST(Edit, refuses_to_name_a_base_that_json_cannot_name) {
    const Folder folder;
    const std::string look = folder.write("caf\xe9.cube", saturated_cube(3));
    const Result result = lutconv(
        {"edit", look, "-o", folder.path("x.cube"), "--save-recipe", folder.path("r.json")});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("caf\\xe9.cube: a recipe can name its base only in UTF-8"),
              std::string::npos)
        << result.err;
    EXPECT_EQ(folder.names().size(), 1U);
}

TEST(Edit, refuses_bad_values_and_bad_recipes_with_the_reason) {
    const Folder folder;
    const auto refused = [&](std::vector<std::string> more, int code, const char* reason) {
        more.insert(more.begin(), {"edit", "-o", folder.path("x.cube")});
        const Result result = lutconv(more);
        EXPECT_EQ(result.exit_code, code) << reason;
        EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
    };
    refused({"identity", "--saturation", "9"}, 3, "--saturation is 9; the range is 0 to 4");
    refused({"identity", "--offset", "1,2"}, 3, "--offset takes one number or three");
    refused({"identity", "--hue-vs-sat", "0=1"}, 3, "--hue-vs-sat takes knots");
    refused({"identity", "--input-encoding", "vlgo"}, 3,
            "there is no curve 'vlgo'; did you mean vlog");
    refused({}, 3, "nothing to edit");
    const std::string bad = folder.write(
        "bad.json", R"({"schema_version": 1, "operators": [{"op": "saturation", "amount": 9}]})");
    refused({"--recipe", bad}, 2, "operators[0].amount is 9");
    const std::string lost =
        folder.write("lost.json", R"({"schema_version": 1, "base": "none.cube"})");
    refused({"--recipe", lost}, 2, "none.cube");
    EXPECT_FALSE(std::filesystem::exists(folder.path("x.cube")));
}

TEST(Edit, knows_a_recipe_by_its_content_also_on_standard_input) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(5)), out = folder.path("o.cube");
    const std::string recipe = folder.path("r.json"), page = folder.path("r.html");
    run({"edit", look, "-o", folder.path("meant.cube"), "--exposure", "1", "--save-recipe",
         recipe});
    json document = json::parse(contents(recipe));
    document["base"] = look;
    const std::string text = document.dump(2);
    const std::string plain = folder.write("recipe", text);
    for (const std::string& path : {std::string("-"), plain}) {
        const Result edited = lutconv({"edit", path, "-o", out, "--allow-outside"}, text);
        EXPECT_EQ(edited.exit_code, 0) << edited.err;
        EXPECT_TRUE(contents(out) == contents(folder.path("meant.cube")));
        const Result report =
            lutconv({"report", path, "--sizes", "2", "-o", page, "--allow-outside"}, text);
        EXPECT_EQ(report.exit_code, 0) << report.err;
    }
    const Result saved =
        lutconv({"edit", "-", "-o", out, "--save-recipe", recipe, "--allow-outside"}, text);
    EXPECT_EQ(saved.exit_code, 0) << saved.err;
    EXPECT_EQ(json::parse(contents(recipe))["base"], "a.cube");
    EXPECT_EQ(
        lutconv({"edit", "-", "--recipe", plain, "-o", out, "--allow-outside"}, text).exit_code, 3);
    EXPECT_EQ(lutconv({"edit", "-", "--recipe", "-", "-o", out}, text).exit_code, 3);
    const std::string cube = saturated_cube(5);
    EXPECT_EQ(lutconv({"edit", "-", "-o", out}, cube).exit_code, 0);
    EXPECT_EQ(lutconv({"report", "-", "--sizes", "2", "-o", page}, cube).exit_code, 0);
    // A recipe cannot name a LUT that is gone with the pipe.
    EXPECT_EQ(lutconv({"edit", "-", "--save-recipe", recipe}, cube).exit_code, 3);
}

TEST(Resample, compose_blend_and_invert_report_their_errors) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(9));
    const std::string out = folder.path("o.cube");
    const json larger = run({"resample", look, "-o", out, "--size", "17"});
    EXPECT_EQ(larger["size"], 17);
    // 17 nodes hold the 9 and their midpoints: nothing but the cells' diagonals differ.
    EXPECT_LT(larger["error"]["absolute"]["mean"], 1e-6);
    EXPECT_GT(run({"resample", look, "-o", out, "--size", "4"})["error"]["absolute"]["max"], 1e-3);

    const std::string wide = folder.write(
        "wide.cube",
        "LUT_3D_SIZE 2\nDOMAIN_MIN -4 -4 -4\nDOMAIN_MAX 4 4 4\n-4 -4 -4\n4 -4 -4\n-4 4 -4\n4 4 -4\n"
        "-4 -4 4\n4 -4 4\n-4 4 4\n4 4 4\n");
    run({"compose", look, wide, "-o", out});
    EXPECT_LT(run({"compare", look, out})["absolute"]["max"], 1e-6);
    EXPECT_GT(run({"compose", wide, look, "-o", out})["clamped_share"], 0.9);

    run({"blend", "identity", look, "--amount", "0", "-o", out});
    EXPECT_EQ(run({"compare", "identity", out})["absolute"]["max"], 0);

    const json inverse = run({"invert", look, "-o", out, "--size", "9"});
    EXPECT_EQ(inverse["nodes"], 729);
    // A third of the look's inputs are clipped, and no inverse brings those back.
    EXPECT_GT(inverse["round_trip"]["absolute"]["mean"], 0.02);
    EXPECT_LT(inverse["round_trip_undoable"]["absolute"]["mean"], 0.02);
}

TEST(Curves, stay_curves_through_every_verb) {
    const Folder folder;
    std::string text = "LUT_1D_SIZE 30\nDOMAIN_MAX 4 4 4\n";
    for (int i = 0; i < 30; ++i) {
        const std::string v = std::to_string(std::sqrt(i / 29.0)) + ' ';
        text += v + v + v + '\n';
    }
    const std::string curve = folder.write("c.cube", text), out = folder.path("o.cube");
    const std::vector<std::vector<std::string>> lines{
        {"edit", curve, "-o", out, "--exposure", "0.5", "--contrast", "1.2"},
        {"edit", "identity", "-o", out, "--gamma", "0.5"},
        {"resample", curve, "-o", out, "--size", "4096"},
        {"compose", curve, curve, "-o", out},
        {"blend", "identity", curve, "-o", out},
        {"blend", curve, curve, "--amount", "0.5", "-o", out},
        {"invert", curve, "-o", out}};
    for (const auto& line : lines) {
        run(line);
        EXPECT_EQ(contents(out).find("LUT_3D_SIZE"), std::string::npos) << line[0];
    }
    EXPECT_EQ(color_at(out, "1", "0.5", "0").substr(0, 2), "4 ");
    run({"resample", curve, "-o", out, "--size", "4096"});
    EXPECT_NE(contents(out).find("LUT_1D_SIZE 4096"), std::string::npos);
    for (const char* name : {"x.csp", "x.spi1d", "x.clf", "x.ctf", "x.cube"}) {
        EXPECT_TRUE(run({"convert", curve, "-o", folder.path(name)})["losses"].empty()) << name;
        EXPECT_EQ(run({"info", folder.path(name)}).contains("cube"), false) << name;
    }
    // What mixes makes a cube behind the curve, whose own bend it keeps.
    const json mixed = run({"edit", curve, "-o", out, "--saturation", "0.5"});
    EXPECT_LT(mixed["error"]["absolute"]["max"], 1e-5);
    EXPECT_NE(contents(out).find("LUT_1D_SIZE 30"), std::string::npos);
    EXPECT_NE(contents(out).find("LUT_3D_SIZE 33"), std::string::npos);
    const Result large = lutconv(
        {"resample", folder.write("a.cube", saturated_cube(5)), "-o", out, "--size", "4096"});
    EXPECT_EQ(large.exit_code, 3);
    EXPECT_NE(large.err.find("--size 4096 is for curves"), std::string::npos) << large.err;
}

TEST(Invert, of_a_curve_tells_its_slopes_and_what_it_loses) {
    const Folder folder;
    const std::string clipped =
        folder.write("c.cube", "LUT_1D_SIZE 5\n0 0 0\n.25 .5 .25\n.5 .25 .5\n1 .75 .75\n1 1 1\n");
    const Result result = lutconv({"invert", clipped, "-o", folder.path("i.cube")});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("at its high end 0.5, 1, 1"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("red is flat over 0.25"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("green turns back over 0.375"), std::string::npos) << result.out;
    EXPECT_EQ(color_at(folder.path("i.cube"), "1", "1", "1"), "1 1 1\n");
}

TEST(Compare, of_a_look_with_itself_is_zero_and_finds_the_worst_color) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(9));
    const json same = run({"compare", look, look});
    EXPECT_EQ(same["absolute"]["max"], 0);
    EXPECT_EQ(same["delta_e_2000"]["max"], 0);
    const json apart = run({"compare", look, "identity"});
    EXPECT_GT(apart["delta_e_2000"]["max"], 1);
    EXPECT_EQ(apart["worst"]["in"].size(), 3U);
}

TEST(RealLooks, go_through_every_verb) {
    if (std::string(EXTRA_DATA).empty()) {
        GTEST_SKIP() << "LUT_EXTRA_DATA is not set";
    }
    const Folder folder;
    const std::string out = folder.path("o.cube");
    std::size_t files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(EXTRA_DATA) / "luts")) {
        ++files;
        const std::string look = entry.path().string();
        run({"edit", look, "-o", out, "--saturation", "1.2"});
        run({"resample", look, "-o", out, "--size", "12", "--interpolation", "tricubic"});
        run({"compose", look, look, "-o", out});
        run({"blend", look, "identity", "--amount", "0.25", "-o", out});
        EXPECT_EQ(run({"compare", look, look})["absolute"]["max"], 0);
        // A 1D table with a flat part has no inverse, and says so.
        const Result inverse = lutconv({"invert", look, "-o", out, "--size", "12"});
        EXPECT_TRUE(inverse.exit_code == 0 ||
                    inverse.err.find("has no inverse") != std::string::npos)
            << inverse.err;
    }
    EXPECT_GT(files, 5U);
}

} // namespace
} // namespace converter_test
