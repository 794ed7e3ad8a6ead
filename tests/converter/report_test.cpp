#include "tests/converter/run_program.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace converter_test {
namespace {

using nlohmann::json;

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
        ++found;
    }
    return found;
}

// The page as a browser has it after running its scripts; empty when there is no Chromium.
std::string opened_in_chromium(const Folder& folder, const std::string& page) {
    const char* const browser = "/usr/bin/chromium";
    if (!std::filesystem::exists(browser)) {
        return {};
    }
    const std::string command =
        std::string("timeout 120 ") + browser +
        " --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
        "--disable-background-networking --disable-component-update --disable-sync "
        "--user-data-dir='" +
        folder.path("profile") + "' --dump-dom 'file://" + page + "' 2>/dev/null >'" +
        folder.path("dom") + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return contents(folder.path("dom"));
}

TEST(Report, is_a_page_whose_points_chromium_shows_with_the_figures_of_its_json) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(9));
    const std::string page = folder.path("report.html");
    const Result result = lutconv({"report", look, "--sizes", "8", "16", "-o", page, "--json",
                                   folder.path("r.json"), "--csv", folder.path("r.csv")});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("Take "), std::string::npos) << result.out;

    const json figures = json::parse(contents(folder.path("r.json")));
    const std::size_t rows = figures["rows"].size();
    EXPECT_GT(rows, 100u);
    EXPECT_EQ(count(contents(folder.path("r.csv")), "\n"), rows + 1);
    EXPECT_FALSE(figures["machine"].get<std::string>().empty());
    std::size_t front = 0;
    for (const json& row : figures["rows"]) {
        front += row["on_front"].get<bool>();
        EXPECT_EQ(row["on_front"].get<bool>(), !row.contains("dominated_by"));
    }
    EXPECT_GT(front, 0u);
    EXPECT_LT(front, rows);

    const std::string source = contents(page);
    // Self-contained: nothing is loaded.
    EXPECT_EQ(source.find("http"), std::string::npos);
    EXPECT_EQ(source.find("src="), std::string::npos);
    EXPECT_EQ(source.find(">nan<"), std::string::npos);
    EXPECT_EQ(source.find("nan\""), std::string::npos);

    const std::string dom = opened_in_chromium(folder, page);
    if (dom.empty()) {
        GTEST_SKIP()
            << "there is no /usr/bin/chromium to open the page in (Debian package chromium)";
    }
    // Four views of two plots with a point for each combination, and a row of the table.
    EXPECT_EQ(count(dom, "data-row=\""), 8 * rows);
    EXPECT_EQ(count(dom, "<tr id=\"row-"), rows);
    EXPECT_EQ(count(dom, "class=\"front\""), 8u);
    EXPECT_EQ(count(dom, "class=\"mark best"), 8u);
    // Where the recommended one errs, without a script; and every patch of the chart.
    EXPECT_EQ(count(source, "class=\"heat\""), 4u);
    EXPECT_EQ(count(source, "class=\"patch\""), 24u + 10 + 11);
    EXPECT_EQ(count(source, "class=\"band\""), 7u);
    // The script filled the filters: two sizes after "all".
    EXPECT_NE(dom.find(">8</option><option>16</option></select>"), std::string::npos);
    // The script ran: headings have become buttons that sort.
    EXPECT_GT(count(dom, "role=\"button\""), 10u);
}

TEST(Report, merges_the_times_of_a_gpu_and_refuses_what_are_none) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(3));
    const std::string times = folder.write("gpu.json", R"({
        "device": "Card 9", "width": 960, "height": 540, "frames": {}, "rows": [
        {"group": "copy", "name": "rgba8", "median_ms": 1, "bytes": 1, "ratio_to_copy": 1},
        {"group": "lut, rgba8 to rgba8", "name": "shared-tetrahedral", "median_ms": 0.5,
         "bytes": 1, "ratio_to_copy": 1.5},
        {"group": "lut, rgba8 to rgba8", "name": "piccolo", "median_ms": 2, "bytes": 1,
         "ratio_to_copy": 6}]})");
    const std::string page = folder.path("r.html"), figures = folder.path("r.json");
    const Result result = lutconv(
        {"report", look, "--sizes", "16", "-o", page, "--json", figures, "--gpu-times", times});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json all = json::parse(contents(figures));
    const json& gpu = all["gpu"];
    EXPECT_EQ(gpu["device"], "Card 9");
    ASSERT_EQ(gpu["rows"].size(), 2u);
    EXPECT_DOUBLE_EQ(gpu["rows"][0]["milliseconds_4K"].get<double>(), 8);
    const json& row = all["rows"][gpu["rows"][0]["row"].get<std::size_t>()];
    EXPECT_EQ(row["lookup"], "tetrahedral");
    EXPECT_EQ(row["storage"], "8");
    EXPECT_TRUE(gpu["rows"][1]["row"].is_null());
    EXPECT_NE(contents(page).find("On a GPU: Card 9"), std::string::npos);

    const Result refused =
        lutconv({"report", look, "--sizes", "2", "-o", page, "--gpu-times", look});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find(look), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find("preview_bench --json"), std::string::npos) << refused.err;
}

TEST(Report, plots_the_orders_of_the_stiff_suite) {
    if (support::is_sanitized && !support::is_thorough()) {
        GTEST_SKIP() << "takes minutes; lutlib's own tests of the suite run here";
    }
    const Folder folder;
    const std::string page = folder.path("stiff.html");
    std::vector<std::string> words{
        "report", "--suite",           "stiff", "-o", page, "--json", folder.path("s.json"),
        "--csv",  folder.path("s.csv")};
    if (!support::is_thorough()) {
        words.insert(words.end(), {"--sizes", "18", "24"});
    }
    const Result result = lutconv(words);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json figures = json::parse(contents(folder.path("s.json")));
    ASSERT_GT(figures["curves"].size(), 100u);
    std::size_t points = 0;
    for (const json& curve : figures["curves"]) {
        points += curve.contains("points") ? curve["points"].size() : 0;
        if (curve["function"] == "kink" && curve["method"] == "tetrahedral") {
            EXPECT_NEAR(curve["order"]["value"].get<double>(), 1, 0.2) << curve["of"];
            EXPECT_EQ(curve["theory"], 1);
        }
    }
    const std::string source = contents(page);
    EXPECT_EQ(count(source, "<tr id=\"row-"), points);
    EXPECT_EQ(count(contents(folder.path("s.csv")), "\n"), points + 1);
    EXPECT_EQ(source.find("nan"), std::string::npos);
}

TEST(Report, writes_all_of_its_files_or_none) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(3));
    const std::string page = folder.path("r.html"), csv = folder.path("r.csv");
    for (const std::string& figures : {std::string("/dev/full"), folder.path("none/r.json")}) {
        const Result result =
            lutconv({"report", look, "--sizes", "2", "-o", page, "--csv", csv, "--json", figures});
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_NE(result.err.find(figures), std::string::npos) << result.err;
        EXPECT_EQ(folder.names(), std::vector<std::string>{"look.cube"});
    }
}

TEST(Report, wants_a_look_or_a_suite) {
    EXPECT_EQ(lutconv({"report", "-o", "-"}).exit_code, 3);
    EXPECT_EQ(lutconv({"report", "--suite", "soft", "-o", "-"}).exit_code, 3);
}

} // namespace
} // namespace converter_test
