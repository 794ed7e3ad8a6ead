// How the scopes are seen in the window, beside what undo brings back (editor::ScopeChoice).
#pragma once

#include "preview/finish/scopes.h"
#include "preview/finish/zoom.h"
#include "preview/panels/rect.h"

#include <array>
#include <optional>

namespace preview::panels {

/// The region for the scopes that is being dragged, see scope_region.h.
struct RegionDrag {
    std::optional<OutputPoint> from; ///< where it began, in shares of the picture; empty: not yet
};

struct ScopesShown {
    bool are_frozen = false;                  ///< they show what they counted when this was set
    std::array<Rect, scopes.size()> places{}; ///< where they are seen; else empty
    FigureSize figures; ///< of those that are written over them, in their pixels
    std::optional<RegionDrag> region_drag;
};

} // namespace preview::panels
