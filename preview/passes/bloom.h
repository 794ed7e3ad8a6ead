// Bloom: runs the steps of a plan (preview/finish/blooms.h) up to its last filter, which the
// finishing pass does.
#pragma once

#include "preview/finish/blooms.h"
#include "preview/passes/pass.h"

namespace preview {

struct [[nodiscard]] BloomLayers {
    BloomPlan plan; ///< empty: no bloom
    std::array<ImageHandle, BloomPlan::max_layers> images;
};

/// `plan` is made for the picture's size. `work` is the format of the
/// pyramid: rgba16f, rgba32f or r11g11b10f. Layers that are kept
/// serve further frames of the same light.
BloomLayers add_bloom(Graph& graph, ImageHandle hdr, const BloomPlan& plan,
                      Format work = Format::rgba16f, bool are_kept = false);

} // namespace preview
