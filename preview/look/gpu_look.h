// A look on the GPU: what its lookup reads, as images and buffers.
#pragma once

#include "preview/gpu/memory.h"
#include "preview/look/look_texels.h"

#include <optional>

namespace preview {

struct GpuLook {
    GpuLook(const gpu::Device& device, const LookData& data);

    const GpuLookup* lookup;
    LookBlock block;
    std::uint32_t place;                           ///< bits of PlaceBits
    std::vector<std::array<float, 4>> conversions; ///< around it; may be empty
    std::optional<gpu::Image> picture, volume, shaper;
    std::optional<gpu::Buffer> nodes; ///< of a shared lookup
    /// Whether a tetrahedral shared lookup into 8 bits computes in half floats, and how many
    /// workgroups a shared one gets.
    bool half_arithmetic;
    std::uint32_t groups;

    /// A table without a lattice.
    bool is_curves() const { return lookup->source == GpuLookup::Source::table && block.size == 0; }

    /// The place that the data say.
    void stand(const LookData& data);
};

} // namespace preview
