// The codes of a picture's colours in another encoding, which scopes count in place of its own
// (preview/finish/scope_levels.h).
#pragma once

#include "preview/finish/scope_levels.h"
#include "preview/passes/pass.h"

namespace preview {

/// Of an rgba8 `picture` as large, rgba8 too. For levels that convert.
ImageHandle add_scope_codes(Graph& graph, ImageHandle picture, const ScopeLevels& levels);

} // namespace preview
