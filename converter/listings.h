// The tables of what there is, as JSON: for verbs that list them, and for Python.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace converter {

/// A row for each engine, with where it is documented.
nlohmann::ordered_json engines_json();
/// {"curves", "gamuts", "adaptations"}, with sources and chromaticities.
nlohmann::ordered_json encodings_json();
/// A row for each operator: its parameters' names, flags, units, ranges and defaults.
nlohmann::ordered_json operators_json();
/// A row for each format of LUT files.
nlohmann::ordered_json formats_json();

} // namespace converter
