// Bloom: runs the steps of a plan (preview/finish/blooms.h) up to its last filter, which the
// finishing pass does.
#pragma once

#include "preview/finish/blooms.h"
#include "preview/passes/pass.h"

namespace preview {

struct [[nodiscard]] Bloomed {
    BloomPlan plan;   ///< empty: no bloom
    ImageHandle glow; ///< what the last filter reads
};

struct BloomWork {
    Format format = Format::rgba16f; ///< of the pyramid
    bool is_kept = false;            ///< the glow serves further frames of the same light
    bool fuses = true;               ///< a dispatch does many steps; else each does one
};

/// Of shaders/common/bloom.glsl.
struct BloomOnset {
    float threshold, knee, parabola;
};

BloomOnset onset_of(const BloomPlan& plan);

/// `plan` is made for the picture's size.
Bloomed add_bloom(Graph& graph, ImageHandle hdr, const BloomPlan& plan, const BloomWork& work = {});

} // namespace preview
