// What the finishing pass does in one trip through memory and what it leaves to passes of its own,
// decided from the effects in use. Plain: no GPU.
#pragma once

#include "preview/effects/effect.h"
#include "preview/finish/compare.h"

namespace preview {

/// What of a frame decides which effects it draws.
struct EffectSurroundings {
    const Compare* compare = &compare_a;
    bool is_display_encoded = false;
    bool has_scene_look = false; ///< a look takes light, so that no codes reach it
    bool has_depth = true;
};

/// Why an effect in use is left out of the frame; empty when it is drawn.
std::string_view left_out_because(const EffectUse& use, const EffectSurroundings& frame);

/// Whether effects of a stage are among those drawn.
bool has_stage(const EffectUses& drawn, Stage stage);

/// The finishing pass composites the bloom and draws the split line itself wherever no effect sits
/// between.
struct Fusion {
    /// An effect reads the light with its bloom: a pass of its own composites it.
    bool is_bloom_apart = false;
    /// An effect changes the finished picture: the line is drawn over it, last.
    bool is_line_apart = false;
    friend bool operator==(const Fusion&, const Fusion&) = default;
};

Fusion fusion_of(const EffectUses& drawn, const Compare& compare);

} // namespace preview
