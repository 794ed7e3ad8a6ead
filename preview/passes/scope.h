// The scopes: counts a picture's codes and draws the counts (preview/finish/scopes.h).
#pragma once

#include "preview/finish/scopes.h"
#include "preview/passes/pass.h"

#include <optional>

namespace preview {

struct [[nodiscard]] ScopePicture {
    BufferHandle counts; ///< shaped as Scope::bins says
    ImageHandle picture; ///< rgba8
};

struct ScopeDrawing {
    Size size;
    bool logarithmic = true; ///< brightness or height by the counts' logarithm, or in proportion
    /// Leave out the figures, with room for those that somebody else writes over the picture.
    std::optional<FigureSize> room_for = std::nullopt;
};

/// Of those columns of an rgba8 `picture`. Every texel is counted once in each plane.
ScopePicture add_scope(Graph& graph, ImageHandle picture, const Scope& scope, ColumnRange range,
                       const ScopeDrawing& drawing);

/// How many columns ScopeBins::columns counts: one for each texel of its plots' width, but no more
/// than the picture has.
std::uint32_t scope_columns(const Scope& scope, ColumnRange range, const ScopeDrawing& drawing);

} // namespace preview
