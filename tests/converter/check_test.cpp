#include "lutlib/formats/cube.h"
#include "lutlib/health/health.h"
#include "lutlib/health/repair.h"
#include "lutlib/survey/stiff_suite.h"
#include "tests/converter/run_program.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace converter_test {
namespace {

using nlohmann::json;

std::string suite_cube(std::string_view name) {
    const lutlib::Lut lut = lutlib::stiff_look_named(name)->make();
    return write_cube(lut, best_dialect(lut));
}

json check(const std::string& look, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"check", look, "--json"});
    return json::parse(lutconv(more).out);
}

TEST(Check, says_each_check_by_name_and_gives_a_verdict_in_words) {
    const Folder folder;
    const std::string look = folder.write("a.cube", suite_cube("shoulder_8"));
    const Result result = lutconv({"check", look});
    EXPECT_EQ(result.exit_code, 0);
    const std::string help = lutconv({"check", "--help"}).out;
    for (const lutlib::HealthCheck& row : lutlib::health_checks()) {
        EXPECT_NE(result.out.find(row.name), std::string::npos) << row.name;
        EXPECT_NE(help.find(row.name), std::string::npos) << row.name;
    }
    for (const lutlib::RepairInfo& row : lutlib::repairs()) {
        EXPECT_NE(help.find(row.help), std::string::npos) << row.name;
    }
    EXPECT_NE(result.out.find("\nhealthy: "), std::string::npos) << result.out;
    EXPECT_EQ(check(look).at("checks").size(), lutlib::health_checks().size());
}

TEST(Check, exits_with_1_only_when_strict_and_unhealthy) {
    const Folder folder;
    const std::string folded = folder.write("folded.cube", suite_cube("folded"));
    const std::string plain = folder.write("plain.cube", saturated_cube(17));
    EXPECT_EQ(lutconv({"check", folded}).exit_code, 0);
    EXPECT_EQ(lutconv({"check", folded, "--strict"}).exit_code, 1);
    EXPECT_NE(lutconv({"check", folded}).out.find("unhealthy"), std::string::npos);
    EXPECT_EQ(lutconv({"check", plain, "--strict"}).exit_code, 0);
    EXPECT_EQ(check(folded).at("healthy"), false);
    EXPECT_EQ(check(plain).at("healthy"), true);
}

TEST(Check, repairs_what_other_verbs_refuse_to_read_and_says_the_change_in_figures) {
    const Folder folder;
    for (const char* name : {"nan.cube", "microsoft_nan.cube", "infinity.cube"}) {
        const std::string broken = std::string(TESTS_BAD) + "/" + name;
        EXPECT_EQ(lutconv({"info", broken}).exit_code, 2) << name;
        EXPECT_EQ(lutconv({"check", broken, "--strict"}).exit_code, 1) << name;
        const std::string out = folder.path(name);
        const json result = check(broken, {"--repair", "-o", out, "--strict"});
        EXPECT_EQ(result.at("healthy"), false);
        EXPECT_EQ(result.at("after").at("healthy"), true);
        ASSERT_EQ(result.at("repairs").size(), 1U) << name;
        EXPECT_EQ(result.at("repairs")[0].at("repair"), "non-finite");
        EXPECT_EQ(result.at("repairs")[0].at("changed_values"), 1);
        EXPECT_EQ(lutconv({"info", out}).exit_code, 0) << name;
    }
}

TEST(Check, repairs_a_spike_and_clamps_only_when_asked) {
    const Folder folder;
    const std::string spike = folder.write("spike.cube", suite_cube("spike_100"));
    const std::string out = folder.path("out.cube");
    EXPECT_EQ(lutconv({"check", spike, "--repair", "-o", out}).exit_code, 0);
    const json moved = json::parse(lutconv({"info", out, "--json"}).out);
    EXPECT_LT(moved.at("distance_from_identity").at("max"), 1e-6);
    const std::string gain = folder.write("gain.cube", suite_cube("gain_1000"));
    EXPECT_TRUE(check(gain, {"--repair", "-o", out}).at("repairs").empty());
    const json clamped = check(gain, {"--repair", "--clamp", "-o", out});
    EXPECT_EQ(clamped.at("repairs")[0].at("repair"), "clamp");
    EXPECT_NEAR(clamped.at("repairs")[0].at("largest_change").get<double>(), 999, 0.01);
}

TEST(Check, needs_repair_and_an_output_together) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(5));
    EXPECT_EQ(lutconv({"check", look, "--repair"}).exit_code, 3);
    EXPECT_EQ(lutconv({"check", look, "-o", folder.path("b.cube")}).exit_code, 3);
    EXPECT_EQ(lutconv({"check", look, "--clamp"}).exit_code, 3);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.cube"});
}

// The looks of the repository, and further ones where they are named.
std::vector<std::string> real_looks() {
    std::vector<std::string> out;
    for (const std::filesystem::path& folder :
         {std::filesystem::path(SAMPLE_LOOKS), std::filesystem::path(EXTRA_DATA) / "luts"}) {
        if (!std::filesystem::is_directory(folder)) {
            continue;
        }
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".cube" || extension == ".CUBE") {
                out.push_back(entry.path().string());
            }
        }
    }
    return out;
}

TEST(Check, measures_what_coarser_lattices_miss_as_compare_does) {
    const Folder folder;
    const std::string coarse = folder.path("coarse.cube");
    const std::vector<std::string> all = real_looks();
    const std::vector<std::string> some(all.begin(),
                                        all.begin() + std::min<std::ptrdiff_t>(3, std::ssize(all)));
    for (const std::string& look : support::all_or(all, some)) {
        const json result = check(look);
        EXPECT_EQ(lutconv({"check", look}).out.find("cannot tell"), std::string::npos) << look;
        for (const json& lattice : result.at("lattices")) {
            const std::string nodes = std::to_string(lattice.at("nodes").get<int>());
            lutconv({"resample", look, "--size", nodes, "--shaper", "none", "-o", coarse});
            const json distance = json::parse(lutconv({"compare", look, coarse, "--json"}).out);
            const double measured = distance.at("absolute").at("max");
            EXPECT_NEAR(lattice.at("absolute").at("max").get<double>(), measured,
                        0.1 * measured + 2e-6)
                << look << " at " << nodes;
        }
    }
}

TEST(Check, repairs_nothing_of_real_looks_that_are_healthy) {
    const Folder folder;
    for (const std::string& look : real_looks()) {
        const json result = check(look, {"--repair", "-o", folder.path("out.cube")});
        EXPECT_TRUE(result.at("repairs").empty() || !result.at("healthy").get<bool>()) << look;
    }
}

TEST(Check, of_a_recipe_measures_against_the_recipe) {
    const json result = check(std::string(SAMPLE_LOOKS) + "/warm_teal.json");
    EXPECT_GT(result.at("lattices")[1].at("delta_e_2000").at("max"), 0.5);
    EXPECT_GT(result.at("gain").at("p99"), result.at("gain").at("p50"));
}

TEST(Check, of_a_black_and_white_look_is_healthy) {
    const Folder folder;
    const std::string grey = folder.path("grey.cube");
    lutconv({"edit", "identity", "--saturation", "0", "-o", grey});
    EXPECT_EQ(lutconv({"check", grey, "--strict"}).exit_code, 0);
}

TEST(Explain, names_what_convert_then_leaves_out_within_the_stated_bound) {
    const Folder folder;
    const std::string look = folder.write("a.cube", suite_cube("shoulder_8"));
    const std::string out = folder.path("b.cube");
    const json said = check(look, {"--explain"}).at("explanation");
    EXPECT_EQ(said.at("not_needed")[0].at("rule"), "separable");
    EXPECT_EQ(said.at("remains"), "a curve of 65 entries");
    const Result done = lutconv({"convert", look, "-o", out, "--explain", "--json"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(json::parse(done.out).at("explanation").at("not_needed"), said.at("not_needed"));
    EXPECT_EQ(json::parse(done.out).at("explanation").at("left_out"), true);
    EXPECT_EQ(said.at("left_out"), false);
    EXPECT_EQ(json::parse(done.out).at("holds"), "a curve of 65 entries");
    EXPECT_LT(std::filesystem::file_size(out) * 100, std::filesystem::file_size(look));
    const json distance = json::parse(lutconv({"compare", look, out, "--json"}).out);
    EXPECT_LE(distance.at("absolute").at("max").get<double>(),
              said.at("bound").get<double>() + 1e-12);
}

TEST(Explain, keeps_what_the_format_needs_and_says_so) {
    const Folder folder;
    const std::string look = folder.write("a.cube", suite_cube("shoulder_2"));
    const Result kept = lutconv({"convert", look, "-o", folder.path("b.spi3d"), "--explain"});
    ASSERT_EQ(kept.exit_code, 0) << kept.err;
    EXPECT_NE(kept.out.find("not needed: "), std::string::npos) << kept.out;
    EXPECT_NE(kept.out.find("kept: "), std::string::npos) << kept.out;
}

TEST(Explain, writes_the_smallest_table_for_an_identity_and_nothing_less_without_the_flag) {
    const Folder folder;
    const std::string look = folder.write("a.cube", suite_cube("identity"));
    lutconv({"convert", look, "-o", folder.path("b.cube"), "--explain"});
    lutconv({"convert", look, "-o", folder.path("c.cube")});
    EXPECT_NE(contents(folder.path("b.cube")).find("LUT_3D_SIZE 2"), std::string::npos);
    EXPECT_NE(contents(folder.path("c.cube")).find("LUT_3D_SIZE 33"), std::string::npos);
}

TEST(Explain, tells_bakers_what_the_engine_cannot_reach) {
    const Folder folder;
    const std::string look =
        folder.write("a.cube", saturated_cube(33, "DOMAIN_MIN 0 0 0\nDOMAIN_MAX 4 4 4\n"));
    const Result result =
        lutconv({"bake", look, "-o", folder.path("a.png"), "--explain", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json nodes = json::parse(result.out).at("explanation").at("unreachable_nodes");
    EXPECT_EQ(nodes.at("by_0_1"), 33 * 33 * 33 - 9 * 9 * 9);
    EXPECT_EQ(nodes.at("by_any_input"), 0);
    const Result piped =
        lutconv({"bake", "-", "-o", folder.path("b.png"), "--explain", "--json"}, contents(look));
    ASSERT_EQ(piped.exit_code, 0) << piped.err;
    EXPECT_EQ(json::parse(piped.out).at("explanation"), json::parse(result.out).at("explanation"));
}

} // namespace
} // namespace converter_test
