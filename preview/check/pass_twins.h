// Passes in double, by what they read in a frame and by what the frame was asked for: the rows of
// twins.cpp. No formula is shared with a shader.
#pragma once

#include "preview/check/observe.h"
#include "preview/check/situation.h"
#include "preview/reference/image.h"

#include <utility>
#include <vector>

namespace preview {

struct TwinInput {
    const Situation& situation;
    /// What the pass samples first, in colours; empty where that has none.
    const reference::Image& image;
    /// All that it samples, in its order; null for what was not observed.
    const std::vector<const Observed*>& sampled;
    Size size; ///< of the result
    const Graph& graph;
    const PassRecord& pass; ///< itself
    const std::vector<Observed>& observed;
};

/// What a pass should have made.
struct Twin {
    reference::Image wanted;
    reference::Image brightness; ///< that differences are relative to
    reference::Image doubt;      ///< by which it may be off besides; empty: nothing

    Twin(reference::Image image) : wanted(std::move(image)), brightness(wanted) {}
};

struct TwinRow {
    std::string_view pass;
    /// Of |pass - twin| / (|twin| + floor), or in place of |twin| what `reach` says.
    double bound, floor;
    double may_be_beyond; ///< share of the texels
    double drift;         ///< of pictures of many texels
    bool (*is_known)(const Situation& situation);
    Twin (*twin)(const TwinInput& in);
    /// Of a pass that the texture unit filters for: texels so far away count as its own brightness,
    /// for the unit's weights have 8 bits. Null: none.
    int (*reach)(const TwinInput& in) = nullptr;
};

std::span<const TwinRow> twin_rows();

} // namespace preview
