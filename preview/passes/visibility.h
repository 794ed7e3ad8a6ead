// The g-buffer without the GPU's rasteriser: compute shaders find the nearest triangle at every
// pixel, then what there is to know of it. Data-centre GPUs rasterise on a small part of the chip;
// this uses all of it.
#pragma once

#include "preview/passes/gbuffer.h"

#include <cstdint>
#include <vector>

namespace preview {

/// Up to 64 triangles of one draw: what a workgroup takes.
struct ClusterBlock {
    static constexpr std::uint32_t triangles = 64;
    std::uint32_t first_index = 0;
    std::int32_t vertex_offset = 0;
    std::uint32_t object = 0;
    std::uint32_t triangle_count = 0;
};

/// The draws' triangles in order.
std::vector<ClusterBlock> cluster_blocks(const std::vector<Draw>& draws);

/// Bytes of the largest buffer that add_visibility() makes.
std::uint64_t visibility_bytes(Size size);

struct VisibilityLimits {
    /// Sides in pixels up to which one invocation rasterises a triangle; at most 32.
    std::uint32_t small_side = 32;
    /// How many larger ones are left to whole workgroups; invocations rasterise the rest.
    std::uint32_t large_triangles = 1U << 16U;
    /// Workgroups that share the large ones' tiles: enough to fill the largest GPUs, few enough to
    /// cost nothing where there is no tile.
    std::uint32_t tile_groups = 4096;
};

/// As add_gbuffer(), pixels on edges apart: vertices snap to 1/256 pixel, and both rasterisers may
/// round that differently. The depth is an r32f image here. Needs 64-bit atomics on buffers
/// (gpu::Device::has_int64_atomics()).
GBuffer add_visibility(Graph& graph, const SceneHandles& scene, Size size,
                       const std::vector<Draw>& draws, const VisibilityLimits& limits = {},
                       bool filters_normals = false, bool keeps_depth = false);

} // namespace preview
