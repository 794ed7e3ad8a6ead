// The looks of a folder, one beside the other. Plain: no drawing.
#pragma once

#include "preview/editor/model.h"

#include <optional>
#include <string>
#include <vector>

namespace preview::editor {

/// The file that the edited look was opened from or saved to, absolute and normal: the recipe's,
/// else its base's; empty when it has none.
std::string file_of_look(const State& state);

struct LookFolder {
    std::string folder;             ///< absolute; empty: none
    std::vector<std::string> names; ///< of what may be looks by their endings, in their order
    std::string reason{};           ///< why there are none; empty when there may be
};

LookFolder looks_in(const std::string& folder);
/// By its ending.
bool may_be_look(const std::string& path);

/// The place in names of the file at `path`; empty for one that is not of the folder.
std::optional<std::size_t> place_of(const LookFolder& folder, const std::string& path);

/// The place after `at`, or for a `step` of -1 before it, around the ends; of `count`, which may
/// not be 0. Without `at` the first, or the last.
std::size_t place_beside(std::optional<std::size_t> at, int step, std::size_t count);

} // namespace preview::editor
