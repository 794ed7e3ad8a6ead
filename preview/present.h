// The finished picture onto an image of the window.
#pragma once

#include "preview/gpu/memory.h"

namespace preview {

/// Clears `target` to black and copies the picture to it, its upper left corner at `place`. `picture`
/// stands in eTransferSrcOptimal and lies within; `target` is left in eTransferDstOptimal.
void record_present(const vk::raii::CommandBuffer& commands, const gpu::Image& picture,
                    vk::Image target, vk::Offset2D place);

} // namespace preview
