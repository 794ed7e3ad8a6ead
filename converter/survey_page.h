// A survey as a page, as JSON and as CSV.
#pragma once

#include "lutlib/survey/stiff_survey.h"
#include "lutlib/survey/survey.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace converter {

std::string survey_html(const lutlib::Survey& survey, const std::string& look);
nlohmann::ordered_json survey_json(const lutlib::Survey& survey, const std::string& look);
std::string survey_csv(const lutlib::Survey& survey);

/// One sentence.
std::string recommendation_text(const lutlib::Survey& survey);

std::string stiff_html(const lutlib::StiffSurvey& survey);
nlohmann::ordered_json stiff_json(const lutlib::StiffSurvey& survey);
std::string stiff_csv(const lutlib::StiffSurvey& survey);

} // namespace converter
