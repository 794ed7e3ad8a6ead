// JSON documents, with errors that name file and line.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace lutlib {

/// What the library says, without its own name and numbers before it.
std::string json_reason(const nlohmann::json::exception& error);

/// Throws Error naming `file`, the line and its text.
nlohmann::json parse_json(std::string_view text, const std::string& file);

} // namespace lutlib
