// A survey as a page, as JSON and as CSV.
#pragma once

#include "converter/gpu_times.h"
#include "lutlib/survey/survey.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace converter {

std::string survey_html(const lutlib::Survey& survey, const std::string& look,
                        const std::optional<GpuTimes>& gpu);
nlohmann::ordered_json survey_json(const lutlib::Survey& survey, const std::string& look,
                                   const std::optional<GpuTimes>& gpu);
std::string survey_csv(const lutlib::Survey& survey);
std::string survey_csv_head(); ///< its first line

/// One sentence.
std::string recommendation_text(const lutlib::Survey& survey);

} // namespace converter
