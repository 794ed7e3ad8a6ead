// What a look does not need, in words and as JSON, for every verb that can say so.
#pragma once

#include "lutlib/resample/simplify.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace converter {

/// What a look does not need, within which bound, what remains, and which nodes no engine reaches.
struct Explanation {
    lutlib::Simplified simplified;
    lutlib::Unreachable unreachable;
    bool left_out = false; ///< the verb wrote the simplified look
    std::string kept;      ///< why it was kept all the same, where it was
};
Explanation explain(const lutlib::Lut& lut, double tolerance);

std::string to_text(const Explanation& explanation);
/// {"not_needed": [...], "left_out", "kept_because", "bound", "remains", "unreachable_nodes":
/// {...}}
nlohmann::ordered_json to_json(const Explanation& explanation);

} // namespace converter
