// What match prints.
#pragma once

#include "converter/match_run.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace converter {

/// `output` as it was asked for.
std::string match_text(const Matched& matched, const std::string& output);
nlohmann::ordered_json match_json(const Matched& matched, const std::string& output);

} // namespace converter
