// The finishing pass: the bloom's last filter, exposure, tone map, the looks of both sides and
// their comparison, fused into one trip through memory.
#pragma once

#include "preview/finish/compare.h"
#include "preview/finish/tonemaps.h"
#include "preview/gpu/memory.h"
#include "preview/look/look_texels.h"
#include "preview/passes/bloom.h"

#include <optional>

namespace preview {

/// A look on the GPU.
struct GpuLook {
    GpuLook(const gpu::Device& device, const LookData& data);

    const GpuLookup* lookup;
    LookBlock block;
    std::optional<gpu::Image> picture, volume, shaper;
    std::optional<gpu::Buffer> nodes; ///< of a shared lookup
    /// Whether a tetrahedral shared lookup into 8 bits computes in half floats, and how many
    /// workgroups a shared one gets.
    bool half_arithmetic;
    std::uint32_t groups;
};

struct FinishSettings {
    const Tonemap* tonemap = nullptr; ///< null: the picture is display-encoded already
    float exposure = 0;               ///< stops
    const Compare* compare = &compares[0];
    float split = 0.5f;   ///< where the line stands, of the width
    float heat_scale = 8; ///< dE2000 at the heat map's end, a multiple of 4 up to 96
    Format format = Format::rgba8;
};

struct [[nodiscard]] Finished {
    ImageHandle picture;
    /// For difference_figures(), after presenting it; empty unless the comparison is `diff`.
    BufferHandle figures;
};

/// What finishes a picture. The looks may be null: none; they must outlive the frame.
struct Finishing {
    ImageHandle picture;
    BloomLayers bloom;
    const GpuLook* look_a = nullptr;
    const GpuLook* look_b = nullptr;
    FinishSettings settings;
};

/// The comparison `side` makes a picture twice as wide as the one given.
Finished add_finish(Graph& graph, const Finishing& finishing);

/// For a pass that finishes texels to count or tell them: binds what shaders/common/finish.glsl
/// reads (bindings 0 to 14) and sets its constants and push constants.
void bind_finish(Graph& graph, Pass& pass, const Finishing& finishing);

/// The size at which a scene is rendered so that its finished picture is `output` wide and high.
Size picture_size(Size output, const Compare& compare);

} // namespace preview
