// What precision, an inexact input and chains do to a look, as tables and as JSON.
#pragma once

#include "lutlib/survey/survey.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace converter {

std::vector<std::string> strain_sections(const lutlib::Strain& strain);
nlohmann::ordered_json strain_json(const lutlib::Strain& strain);

} // namespace converter
