// The scopes: counts a picture's codes and draws the counts (preview/finish/scopes.h).
#pragma once

#include "preview/finish/scopes.h"
#include "preview/passes/pass.h"

namespace preview {

struct [[nodiscard]] ScopePicture {
    BufferHandle counts; ///< shaped as Scope::bins says
    ImageHandle picture; ///< rgba8
};

/// Of those columns of an rgba8 `picture`, drawn in `size`, with brightness or height by the
/// logarithm of the counts or in proportion to them. Every texel is counted once in each plane.
ScopePicture add_scope(Graph& graph, ImageHandle picture, const Scope& scope, ColumnRange range,
                       Size size, bool logarithmic);

/// How many columns ScopeBins::columns counts: one for each texel of its plots' width, but no more
/// than the picture has.
std::uint32_t scope_columns(const Scope& scope, ColumnRange range, Size size);

} // namespace preview
