// What `lutpreview check` has found, for people and as JSON.
#pragma once

#include "preview/check/check.h"
#include "terminal/table.h"

#include <string>

namespace preview {

/// A part for each kind of finding; with `only_faults` rows that hold are left out.
terminal::Table table_of(const CheckReport& report, bool only_faults);
std::string to_json(const CheckReport& report, const std::string& device, Size size);

} // namespace preview
