// The finished picture onto an image of the window.
#pragma once

#include "preview/gpu/memory.h"

#include <span>

namespace preview {

struct Placed {
    const gpu::Image* picture = nullptr;
    vk::Offset2D place; ///< of its upper left corner in the target
};

/// Clears `target` to the grey that surrounds pictures (passes/magnify.h) and copies the pictures
/// to their places, where they must lie within it and apart. They stand in eTransferSrcOptimal;
/// `target` is left in eTransferDstOptimal.
void record_present(const vk::raii::CommandBuffer& commands, std::span<const Placed> pictures,
                    vk::Image target);

} // namespace preview
