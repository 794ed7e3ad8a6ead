// What verbs print: figures as text or as JSON, from one description.
#pragma once

#include "lutlib/format.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/metrics/viewing.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace converter {

/// {"p99", "mean", "p95", "count", "max"} and where the maximum was found: "at", "largest_seen"
nlohmann::ordered_json to_json(const lutlib::ErrorStats& stats);

/// {"output", "reference_white"}
nlohmann::ordered_json to_json(const lutlib::Viewing& viewing);

/// As io::figures_text().
std::string to_text(const lutlib::ErrorStats& stats);

/// "input 0..4 cut to 0..1: 3 units of input"
std::string loss_text(const lutlib::Loss& loss);

/// Somebody else's text within a line of ours: control characters as in C ("\n", "\x1b").
std::string one_line(std::string_view text);
/// What text for people calls a path: io::input_name() or io::output_name() in one line.
std::string input_text(const std::string& path);
std::string output_text(const std::string& path);

/// The whole document, indented. What is no UTF-8, as file names need not be, becomes U+FFFD.
std::string json_text(const nlohmann::ordered_json& json);

/// Prints to standard output, or to standard error when standard output carries `output` ("-").
/// Throws Error where standard output cannot take it.
void print(const std::string& text, const std::string& output);
void print(const nlohmann::ordered_json& json, const std::string& output);

} // namespace converter
