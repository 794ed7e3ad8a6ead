// Sets of primaries as rows. A new one is a row in its maker's file in rows/, its line in
// rows/all.h and its line in encoding.cpp's table.
#pragma once

#include "lutlib/color/primaries.h"

#include <span>
#include <string_view>

namespace lutlib {

struct Gamut {
    std::string_view name;
    std::string_view label;
    std::string_view source; ///< where the maker publishes the chromaticities
    Primaries primaries;
};

std::span<const Gamut* const> gamuts();
/// Null for an unknown name. Case and all but letters and digits do not count.
const Gamut* gamut_named(std::string_view name);

} // namespace lutlib
