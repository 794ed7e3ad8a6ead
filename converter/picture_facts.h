// What a LUT picture is, beside the look in it: its layout, its file, and who takes it as it is.
#pragma once

#include "lutlib/io/look.h"
#include "lutlib/io/png.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace converter {

struct PictureFacts {
    std::string text; ///< lines for people
    nlohmann::ordered_json json;
};

/// Which engines take a picture of a lattice as it is, and why others of its layout do not.
struct Takers {
    std::vector<std::string_view> names, others;
    std::vector<std::string> reasons; ///< "not for unity: ..."
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
};
Takers takers_of(const lutlib::io::PngImage& image, const lutlib::Layout& layout, int size);

/// Of a picture that was made in a layout rather than for an engine: who takes it, and what makes
/// one for the others.
std::string takers_text(const Takers& takers);

/// Nothing of a look that is no picture. `bytes`: its file's.
std::optional<PictureFacts> picture_facts(const std::string& bytes, const lutlib::io::Look& look);

} // namespace converter
