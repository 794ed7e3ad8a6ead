// JSON documents, with errors that name file and line.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace lutlib {

/// Throws Error naming `file`, the line and its text.
nlohmann::json parse_json(std::string_view text, const std::string& file);

} // namespace lutlib
