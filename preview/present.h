// The finished picture onto an image of the window.
#pragma once

#include "preview/gpu/memory.h"

namespace preview {

/// Clears `target` to black and copies the picture to its upper left corner. `picture` stands in
/// eTransferSrcOptimal and is no larger; `target` is left in eTransferDstOptimal.
void record_present(const vk::raii::CommandBuffer& commands, const gpu::Image& picture,
                    vk::Image target);

} // namespace preview
