// What is said of a graded picture.
#pragma once

#include "converter/grade.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace converter {

/// "1920x1080 pixels, uint8".
std::string size_text(const Graded& graded);

/// What was made of its pixels, a line each.
std::vector<std::string> lines_of(const PixelCounts& counts);

/// All else, a line each. `output` names the new file.
std::vector<std::string> lines_of(const Graded& graded, const Grading& grading,
                                  const std::string& output);

/// {"picture", "output", "width", "height", "depth", "pixels_outside_domain",
/// "pixels_not_a_number", "pixels_clamped", "encodings", "remarks", "not_kept"}
nlohmann::ordered_json to_json(const Graded& graded, const std::string& picture,
                               const std::string& output);

} // namespace converter
