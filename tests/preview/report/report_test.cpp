// What studies find of a small scene, and that the page and the figures have all of it.
#include "tests/preview/report/report_fixture.h"

#include "preview/look/gpu_lookups.h"
#include "preview/report/choose.h"
#include "preview/report/columns.h"
#include "preview/report/figures.h"
#include "preview/report/page.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace preview::report {
namespace {

const Row& row_of(const std::vector<Row>& rows, const std::string& input,
                  const std::string& variant) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
        return row.input == input && row.variant == variant;
    });
    if (found == rows.end()) {
        throw std::runtime_error("there is no row of " + variant + " on " + input);
    }
    return *found;
}

TEST_F(ReportTest, bloom_errs_less_the_more_its_pyramid_keeps) {
    const Situation plain = wide(showing("plain"));
    const auto rows = rows_of_one(bloom_study, plain, {64, 36});
    for (const char* const input : {"windows", "sun disc"}) {
        const auto error = [&](const char* variant) {
            return row_of(rows, input, variant).pass->relative_l2;
        };
        EXPECT_LT(error("gaussian, rgba32f"), 0.25) << input;
        EXPECT_NE(error("gaussian, rgba16f"), error("gaussian, r11g11b10f")) << input;
        EXPECT_NE(error("gaussian, rgba16f"), error("gaussian, rgba32f")) << input;
    }
    // What is fainter than a small float holds is lost.
    const auto drift = [&](const char* variant) {
        return std::abs(row_of(rows, "impulse", variant).pass->drift);
    };
    EXPECT_LT(drift("gaussian, rgba16f"), drift("gaussian, r11g11b10f"));
    EXPECT_TRUE(row_of(rows, own(plain), "glare, rgba16f").is_usual);
    EXPECT_TRUE(row_of(rows, "impulse", "glare, rgba16f").pass->centroid_shift.has_value());
    EXPECT_TRUE(row_of(rows, "sun disc", "glare, rgba16f").pass->unrest.has_value());
    EXPECT_FALSE(row_of(rows, "windows", "none").pass.has_value());
    EXPECT_GT(row_of(rows, "windows", "none").picture.relative_l2,
              row_of(rows, "windows", "glare, rgba16f").picture.relative_l2);
}

TEST_F(ReportTest, more_samples_and_finer_maps_come_nearer) {
    const Situation sample = showing("sample");
    const auto occlusion = rows_of_one(occlusion_study, sample, size);
    EXPECT_LT(row_of(occlusion, own(sample), "64 samples").pass->relative_l2,
              row_of(occlusion, own(sample), "1 samples").pass->relative_l2);
    const auto shadows = rows_of_one(shadow_study, sample, size);
    EXPECT_LT(row_of(shadows, own(sample), "2048x2048").pass->relative_l2,
              row_of(shadows, own(sample), "128x128").pass->relative_l2);
    EXPECT_LT(row_of(shadows, own(sample), "128x128").picture.relative_l2,
              row_of(shadows, own(sample), "none").picture.relative_l2);
    const auto sky = rows_of_one(surroundings_study, sample, size);
    EXPECT_LT(row_of(sky, own(sample), "64x32").pass->relative_l2,
              row_of(sky, own(sample), "16x8").pass->relative_l2);
}

TEST_F(ReportTest, lookups_err_as_their_storage_says) {
    const auto rows = rows_of_one(lookup_study, showing("plain"), size);
    std::set<std::string> seen;
    for (const Row& row : rows) {
        seen.insert(row.variant);
        if (row.variant != "none") {
            EXPECT_LT(row.picture.delta_e_2000.p99, 12) << row.variant << " on " << row.input;
        }
    }
    for (const GpuLookup& lookup : gpu_lookups()) {
        EXPECT_TRUE(seen.contains(std::string(lookup.name))) << lookup.name;
    }
    EXPECT_LT(row_of(rows, "ramps", "tetrahedral").picture.delta_e_2000.p99,
              row_of(rows, "ramps", "shared-tetrahedral").picture.delta_e_2000.p99);
    EXPECT_GT(row_of(rows, "ramps", "none").picture.delta_e_2000.p99, 1);
}

TEST_F(ReportTest, depth_of_field_and_antialiasing_come_nearer_than_nothing) {
    const Situation sample = showing("sample");
    // Nothing in the studio is far enough from the focus for so few texels.
    const auto lens = rows_made(depth_of_field_study, sample, {96, 54});
    EXPECT_LT(row_of(lens, "sample", "49 points").picture.relative_l2,
              row_of(lens, "sample", "none").picture.relative_l2);
    const auto edges = rows_of_one(antialiasing_study, sample, {96, 54});
    EXPECT_LT(row_of(edges, own(sample), "specular and fxaa").picture.relative_l2,
              row_of(edges, own(sample), "none").picture.relative_l2);
}

TEST_F(ReportTest, every_row_is_finite_timed_and_beaten_by_none_of_another_group) {
    const RendererReport& report = whole();
    std::set<const Study*> seen;
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const Row& row = report.rows[i];
        seen.insert(row.study);
        ASSERT_TRUE(std::isfinite(row.picture.relative_l2)) << row.variant;
        ASSERT_TRUE(std::isfinite(row.picture.delta_e_2000.max)) << row.variant;
        ASSERT_GE(row.time.median, 0);
        ASSERT_LE(row.time.low, row.time.high);
        const Row& by = report.rows[row.dominated_by];
        EXPECT_EQ(by.study, row.study);
        EXPECT_EQ(by.input, row.input);
        EXPECT_EQ(by.size, row.size);
        EXPECT_LE(by.picture.relative_l2, row.picture.relative_l2);
        EXPECT_LE(by.time.median, row.time.median);
    }
    for (const Study* const study : studies()) {
        EXPECT_TRUE(seen.contains(study)) << study->name;
    }
    ASSERT_TRUE(report.choice.has_value());
    EXPECT_TRUE(report.choice->is_kept);
    // More time than any takes buys the least error that was predicted.
    EXPECT_EQ(report.choice->chosen, report.choice->front.size() - 1);
    EXPECT_FALSE(report.choice->steps.empty());
    for (const SavingRow& row : report.savings) {
        EXPECT_TRUE(row.holds()) << row.name << ": " << row.largest;
    }
    ASSERT_EQ(report.growth.size(), 5U);
    for (const Growth& growth : report.growth) {
        EXPECT_GE(growth.points.size(), 2U) << growth.name;
    }

    const std::string page = to_html(report), csv = to_csv(report);
    const auto json = nlohmann::json::parse(to_json(report));
    EXPECT_EQ(json["rows"].size(), report.rows.size());
    EXPECT_EQ(json["is_a_cpu"].get<bool>(), report.is_cpu);
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
              report.rows.size() + 1);
    for (const Study* const study : studies()) {
        EXPECT_NE(page.find(std::string(study->title)), std::string::npos);
        EXPECT_NE(page.find(std::string(study->reference)), std::string::npos) << study->name;
    }
    // A CPU's times are called so, and stand in no key of a GPU's.
    const char* const key = report.is_cpu ? "gpu_milliseconds" : "cpu_milliseconds";
    EXPECT_EQ(json.dump().find(key), std::string::npos);
    EXPECT_EQ(page.find("milliseconds of a CPU") != std::string::npos, report.is_cpu);
}

TEST_F(ReportTest, an_error_that_is_asked_for_is_kept_by_what_was_measured) {
    ReportSettings settings = quick();
    settings.budget.reset();
    settings.max_delta_e = 60;
    const Situation studio = wide(showing("studio"));
    const auto easy = choice_of(tools, studio, settings, whole().rows);
    ASSERT_TRUE(easy.has_value());
    EXPECT_TRUE(easy->is_kept);
    EXPECT_LE(easy->measured.error.delta_e_2000.p99, 60);
    settings.max_delta_e = 1e-9;
    const auto impossible = choice_of(tools, studio, settings, whole().rows);
    EXPECT_FALSE(impossible->is_kept);
    EXPECT_EQ(impossible->chosen, impossible->front.size() - 1);
}

} // namespace
} // namespace preview::report
