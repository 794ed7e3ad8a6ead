// The look of one side on the GPU, replaced while frames are in flight.
#pragma once

#include "preview/gpu/commands.h"
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"

namespace preview {

/// New texels of unchanged shape are copied into the images by the queue itself: after every frame
/// that was submitted before, ahead of every later one. No frame waits, and none sees a half.
class LookSlot {
  public:
    explicit LookSlot(const gpu::Device& device);

    /// A look that may be left out is. Frames submitted before keep the look that they had; one of
    /// another shape waits for the GPU.
    void set(const LoadedLook& look);
    /// Null: no look.
    const GpuLook* look() const { return shown_ ? &*look_ : nullptr; }

  private:
    struct Upload {
        gpu::Commands commands;
        std::vector<gpu::Buffer> staging;
    };

    void copy(const LookData& data);

    const gpu::Device& device_;
    std::vector<Upload> uploads_;
    std::size_t turn_ = 0;
    std::optional<GpuLook> look_;
    LookData shape_; ///< of look_, without texels
    bool shown_ = false;
};

} // namespace preview
