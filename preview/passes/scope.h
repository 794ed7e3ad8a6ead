// The scopes: counts a picture's codes and draws the counts (preview/finish/scopes.h).
#pragma once

#include "preview/finish/scopes.h"
#include "preview/passes/pass.h"

#include <optional>

namespace preview {

/// What a scope has counted.
struct [[nodiscard]] ScopeCounts {
    BufferHandle counts;                 ///< shaped as Scope::bins says
    std::uint32_t columns = 0;           ///< of ScopeBins::columns
    std::uint32_t width = 0, height = 0; ///< of what was counted, in texels
};

struct [[nodiscard]] ScopePicture {
    BufferHandle counts;
    ImageHandle picture; ///< rgba8
};

struct ScopeDrawing {
    Size size;
    bool logarithmic = true; ///< brightness or height by the counts' logarithm, or in proportion
    /// Leave out the figures, with room for those that somebody else writes over the picture.
    std::optional<FigureSize> room_for = std::nullopt;
    ScopeLevels levels{}; ///< what the picture's codes stand for
    float gain = 1;       ///< counts are multiplied with it
};

/// Counts that area of an rgba8 `picture`. Every texel of it is counted once in each plane.
ScopeCounts count_scope(Graph& graph, ImageHandle picture, const Scope& scope,
                        const ScopeArea& area, const ScopeDrawing& drawing);
/// Draws what was counted, in this size or another.
ImageHandle draw_scope(Graph& graph, const Scope& scope, const ScopeCounts& counted,
                       const ScopeDrawing& drawing);
/// Both.
ScopePicture add_scope(Graph& graph, ImageHandle picture, const Scope& scope, const ScopeArea& area,
                       const ScopeDrawing& drawing);

/// How many columns ScopeBins::columns counts: one for each texel of its plots' width, but no more
/// than the area has.
std::uint32_t scope_columns(const Scope& scope, const ScopeArea& area, const ScopeDrawing& drawing);

} // namespace preview
