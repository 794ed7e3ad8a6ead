#include "converter/gpu_times.h"
#include "converter/report.h"
#include "converter/survey_columns.h"
#include "converter/survey_page.h"
#include "converter/survey_sections.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace converter {
namespace {

using lutlib::Survey;
using lutlib::SurveyRow;

std::string figures(const SurveyRow& row) {
    const auto& e = row.error.delta_e_2000;
    return fmt::format("dE2000 p99 {:.3g}, mean {:.3g}, max {:.3g}; {} bytes; {:.3g} ns a pixel{}",
                       e.p99, e.mean, e.max, row.bytes, 1e9 * row.pixel.median,
                       lutlib::is_emulated(*row.what.lookup) ? ", emulated on the CPU" : "");
}

nlohmann::ordered_json row_json(const SurveyRow& row) {
    nlohmann::ordered_json out{{"size", row.what.size},
                               {"shaper", row.what.shaper->name},
                               {"storage", row.what.storage->name},
                               {"lookup", row.what.lookup->name},
                               {"filling", row.what.fitted ? "fitted" : "point-sampled"},
                               {"absolute", to_json(row.error.absolute)},
                               {"delta_e_2000", to_json(row.error.delta_e_2000)},
                               {"delta_e_itp", to_json(row.error.delta_e_itp)},
                               {"bytes", row.bytes},
                               {"bake_seconds", row.bake_seconds},
                               {"ns_per_pixel",
                                {{"median", 1e9 * row.pixel.median},
                                 {"low_95", 1e9 * row.pixel.low},
                                 {"high_95", 1e9 * row.pixel.high},
                                 {"best", 1e9 * row.pixel.best},
                                 {"repetitions", row.pixel.repetitions},
                                 {"emulated", lutlib::is_emulated(*row.what.lookup)}}}};
    for (const Raster& raster : rasters) {
        out[std::string("milliseconds_") + raster.name] = milliseconds(row, raster);
    }
    return out;
}

} // namespace

std::string recommendation_text(const Survey& survey) {
    const lutlib::Recommendation& r = survey.recommendation;
    const double promise = survey.settings.promise;
    const SurveyRow& best = survey.rows[r.row];
    if (!r.kept) {
        return fmt::format("No combination stays within dE2000 {:g}; {} comes nearest: {}.",
                           promise, to_text(best.what), figures(best));
    }
    std::string out = fmt::format("Take {}, the smallest that stays within dE2000 {:g}: {}",
                                  to_text(best.what), promise, figures(best));
    const SurveyRow& fastest = survey.rows[r.fastest];
    return out + (r.fastest == r.row ? "; nothing faster does so either."
                                     : fmt::format("; the fastest that does so is {} ({:.3g} ns a "
                                                   "pixel, {} bytes).",
                                                   to_text(fastest.what),
                                                   1e9 * fastest.pixel.median, fastest.bytes));
}

nlohmann::ordered_json survey_json(const Survey& survey, const std::string& look,
                                   const std::optional<GpuTimes>& gpu) {
    const lutlib::Recommendation& r = survey.recommendation;
    nlohmann::ordered_json out{
        {"look", look},
        {"machine", lutlib::machine_text()},
        {"colours", survey.colors},
        {"timed_pixels", survey.settings.pixels},
        {"largest_seen", survey.largest_seen},
        {"clamped", survey.clamped},
        {"outside_display", {{"share", survey.outside.share}, {"most", survey.outside.most}}},
        {"notes", survey.notes},
        {"recommendation",
         {{"words", recommendation_text(survey)},
          {"row", r.row},
          {"promise_delta_e_2000", survey.settings.promise},
          {"kept", r.kept}}}};
    const std::vector<std::size_t> by = dominators_of(survey);
    for (std::size_t i = 0; i < survey.rows.size(); ++i) {
        nlohmann::ordered_json row = row_json(survey.rows[i]);
        row["on_front"] = by[i] == lutlib::not_dominated;
        if (by[i] != lutlib::not_dominated) {
            row["dominated_by"] = by[i];
        }
        out["rows"].push_back(std::move(row));
    }
    out["strain"] = strain_json(survey.strain);
    if (gpu) {
        out["gpu"] = to_json(*gpu);
    }
    return out;
}

std::string survey_csv_head() {
    std::vector<std::string> head{"size", "shaper", "storage", "lookup", "filling"};
    for (const SurveyMetric& metric : survey_metrics) {
        head.emplace_back(metric.name);
    }
    for (const char* name : {"bytes", "bake_seconds", "ns_per_pixel", "ns_low_95", "ns_high_95",
                             "ns_best", "ns_emulated", "ms_1080p", "ms_4K", "on_front"}) {
        head.emplace_back(name);
    }
    return csv_line(head);
}

std::string survey_csv(const Survey& survey) {
    std::string out = survey_csv_head();
    const std::vector<std::size_t> by = dominators_of(survey);
    for (std::size_t i = 0; i < survey.rows.size(); ++i) {
        const SurveyRow& row = survey.rows[i];
        std::vector<std::string> words{
            std::to_string(row.what.size), std::string(row.what.shaper->name),
            std::string(row.what.storage->name), std::string(row.what.lookup->name),
            row.what.fitted ? "fitted" : "point-sampled"};
        for (const SurveyMetric& metric : survey_metrics) {
            words.push_back(fmt::format("{:.9g}", metric.of(row.error)));
        }
        words.push_back(std::to_string(row.bytes));
        for (const double value : {row.bake_seconds, 1e9 * row.pixel.median, 1e9 * row.pixel.low,
                                   1e9 * row.pixel.high, 1e9 * row.pixel.best}) {
            words.push_back(fmt::format("{:.6g}", value));
        }
        words.emplace_back(lutlib::is_emulated(*row.what.lookup) ? "1" : "0");
        for (const Raster& raster : rasters) {
            words.push_back(fmt::format("{:.6g}", milliseconds(row, raster)));
        }
        words.emplace_back(by[i] == lutlib::not_dominated ? "1" : "0");
        out += csv_line(words);
    }
    return out;
}

} // namespace converter
