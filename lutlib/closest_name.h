// Which name a misspelled one meant.
#pragma once

#include <span>
#include <string_view>

namespace lutlib {

/// Of these names the one of which two edits (one, for names of up to three letters) make what was
/// asked for: letters put in, left out, replaced or swapped, capitals aside. Empty when there is
/// none.
std::string_view closest_name(std::string_view name, std::span<const std::string_view> names);

} // namespace lutlib
