// The finishing pass: the bloom's last filter, exposure, tone map, the looks of both sides and
// their comparison, fused into one trip through memory.
#pragma once

#include "preview/finish/compare.h"
#include "preview/finish/tonemaps.h"
#include "preview/finish/wipe.h"
#include "preview/passes/bloom.h"

#include <cstdint>
#include <span>

namespace preview {

struct GpuLook;

struct FinishSettings : Wipe {
    const Tonemap* tonemap = nullptr; ///< null: the picture is display-encoded already
    float exposure = 0;               ///< stops
    const Compare* compare = &compare_a;
    float heat_scale = 8;  ///< dE2000 at the heat map's end, a multiple of 4 up to 96
    bool has_marks = true; ///< draw the split line or the heat map's scale; else a later pass does
    Format format = Format::rgba8;
    std::string_view name = "finish"; ///< of the pass
};

struct [[nodiscard]] Finished {
    ImageHandle picture;
    /// For difference_figures(), after presenting it; empty unless the comparison is `diff`.
    BufferHandle figures;
};

/// What finishes a picture. The looks may be null: none; they must outlive the frame.
struct Finishing {
    ImageHandle picture;
    Bloomed bloom;
    const GpuLook* look_a = nullptr;
    const GpuLook* look_b = nullptr;
    FinishSettings settings;
};

/// The comparison `side` makes a picture twice as wide as the one given.
Finished add_finish(Graph& graph, const Finishing& finishing);

/// For a pass that finishes texels to count or tell them: binds what shaders/common/finish.glsl
/// reads (bindings 0 to 12) and sets its constants and push constants. The shader's own constants
/// follow from 10 on.
void bind_finish(Graph& graph, Pass& pass, const Finishing& finishing,
                 std::span<const std::uint32_t> own_constants = {});

} // namespace preview
