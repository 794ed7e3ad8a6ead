// The survey of the stiff suite as a page, as JSON and as CSV.
#pragma once

#include "lutlib/survey/stiff_survey.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace converter {

std::string stiff_html(const lutlib::StiffSurvey& survey);
nlohmann::ordered_json stiff_json(const lutlib::StiffSurvey& survey);
std::string stiff_csv(const lutlib::StiffSurvey& survey);
std::string stiff_csv_head(); ///< its first line

} // namespace converter
