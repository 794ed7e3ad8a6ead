// A verb that lists a table.
#pragma once

#include "converter/command.h"
#include "terminal/table.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace converter {

/// A verb that prints a table, as wide as the terminal is, or by --json; `json_help` says what that
/// holds.
Run declare_listing(Verb& verb, const std::string& json_help, terminal::Table (*as_table)(),
                    nlohmann::ordered_json (*as_json)());

} // namespace converter
