// What a look does not need, in words and as JSON, for every verb that can say so.
#pragma once

#include "lutlib/simplify.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace converter {

/// What was left out of `lut`, within which bound, what remains, and which nodes no engine reaches.
struct Explanation {
    lutlib::Simplified simplified;
    lutlib::Unreachable unreachable;
    /// Why it was kept all the same; empty where it was left out, or only looked for.
    std::string kept;
};
Explanation explain(const lutlib::Lut& lut, double tolerance);

std::string to_text(const Explanation& explanation);
/// {"left_out": [...], "bound", "remains", "unreachable_nodes": {...}}
nlohmann::ordered_json to_json(const Explanation& explanation);

} // namespace converter
