// What a LUT picture is, beside the look in it: its layout, its file, and who takes it as it is.
#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace converter {

struct PictureFacts {
    std::string text; ///< lines for people
    nlohmann::ordered_json json;
};

/// Nothing for a file that is no picture. Throws Error where its layout cannot be told.
std::optional<PictureFacts> picture_facts(const std::string& bytes, const std::string& path);

} // namespace converter
