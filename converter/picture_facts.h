// What a LUT picture is, beside the look in it: its layout, its file, and who takes it as it is.
#pragma once

#include "lutlib/io/look.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace converter {

struct PictureFacts {
    std::string text; ///< lines for people
    nlohmann::ordered_json json;
};

/// Nothing of a look that is no picture. `bytes`: its file's.
std::optional<PictureFacts> picture_facts(const std::string& bytes, const lutlib::io::Look& look);

} // namespace converter
