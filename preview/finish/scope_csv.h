// A scope's counts as a table for other programs.
#pragma once

#include "preview/finish/scopes.h"

#include <span>
#include <string>

namespace preview {

/// A row for each place that has any: plane, column, level, what the level stands for, and how many
/// texels; of a vectorscope Cb and Cr as codes about 128, of a histogram every level with its
/// planes beside each other. `counts` as the scope's row says.
std::string scope_csv(const Scope& scope, std::span<const std::uint32_t> counts,
                      const ScopeLevels& levels);

} // namespace preview
