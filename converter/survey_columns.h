// What a survey tells of each combination, for every form that it is told in.
#pragma once

#include "lutlib/plot/scatter.h"
#include "lutlib/survey/pareto.h"
#include "lutlib/survey/survey.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace converter {

struct SurveyMetric {
    const char* name;
    double (*of)(const lutlib::Difference& d);
};
inline constexpr std::array<SurveyMetric, 9> survey_metrics{{
    {"dE2000 p99", [](const lutlib::Difference& d) { return d.delta_e_2000.p99; }},
    {"dE2000 mean", [](const lutlib::Difference& d) { return d.delta_e_2000.mean; }},
    {"dE2000 max", [](const lutlib::Difference& d) { return d.delta_e_2000.max; }},
    {"dE-ITP p99", [](const lutlib::Difference& d) { return d.delta_e_itp.p99; }},
    {"dE-ITP mean", [](const lutlib::Difference& d) { return d.delta_e_itp.mean; }},
    {"dE-ITP max", [](const lutlib::Difference& d) { return d.delta_e_itp.max; }},
    {"abs p99", [](const lutlib::Difference& d) { return d.absolute.p99; }},
    {"abs mean", [](const lutlib::Difference& d) { return d.absolute.mean; }},
    {"abs max", [](const lutlib::Difference& d) { return d.absolute.max; }},
}};

struct SurveyCost {
    const char* label;
    double (*of)(const lutlib::SurveyRow& row);
};
inline constexpr std::array<SurveyCost, 2> survey_costs{{
    {"nanoseconds a pixel, one core",
     [](const lutlib::SurveyRow& r) { return 1e9 * r.pixel.median; }},
    {"bytes", [](const lutlib::SurveyRow& r) { return static_cast<double>(r.bytes); }},
}};

/// Milliseconds of a picture on one core.
struct Raster {
    const char* name;
    double pixels;
};
inline constexpr std::array<Raster, 2> rasters{{{"1080p", 1920.0 * 1080}, {"4K", 3840.0 * 2160}}};
inline double milliseconds(const lutlib::SurveyRow& row, const Raster& raster) {
    return 1e3 * row.pixel.median * raster.pixels;
}

/// Of each row another that is no worse in largest dE2000, time and bytes, and better in one; see
/// lutlib::dominators().
std::vector<std::size_t> dominators_of(const lutlib::Survey& survey);

/// "33, half, tetrahedral": for places where there is little room.
std::string short_name(const lutlib::Combination& c);

std::size_t lookup_index(const lutlib::Lookup& lookup);
/// One for each lookup; an emulated one says so.
std::vector<plot::Series> lookup_series();

/// "a,b,c\n"
std::string csv_line(const std::vector<std::string>& words);

} // namespace converter
