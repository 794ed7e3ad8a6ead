// Finding rows of a long list by what is typed.
#pragma once

#include <string_view>

namespace preview::editor {

/// Whether every word of `typed` stands somewhere in `text`, in letters of any case (ASCII). An
/// empty `typed` finds everything.
bool is_found(std::string_view text, std::string_view typed);

} // namespace preview::editor
