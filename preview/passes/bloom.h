// Bloom: runs the steps of a plan (preview/finish/blooms.h) up to its last filter, which the finishing
// pass does.
#pragma once

#include "preview/finish/blooms.h"
#include "preview/passes/pass.h"

namespace preview {

struct BloomLayers {
    BloomPlan plan; ///< empty: no bloom
    std::array<Handle, BloomPlan::max_layers> images;
};

/// `plan` is made for the picture's size. `work` is the format of the pyramid.
BloomLayers add_bloom(Graph& graph, Handle hdr, const BloomPlan& plan,
                      Format work = Format::rgba16f);

} // namespace preview
