// Small pictures on the GPU, each rendered into a cell that keeps it.
#pragma once

#include "preview/frame/settings.h"
#include "preview/frame/shown.h"
#include "preview/graph/execute.h"
#include "preview/look/look_slot.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace preview {

class ThumbnailCells {
  public:
    /// Of some 160x90 pixels in 8 bits: less than 4 MB.
    static constexpr std::size_t count = 64;

    explicit ThumbnailCells(const gpu::Device& device);

    /// Renders a picture under `look`, of side B, into a cell in place of what that holds, without
    /// waiting for it. The light is kept for the next one that has the same. Throws as
    /// build_frame().
    void draw(std::size_t cell, FrameInputs inputs, const FrameSettings& settings,
              const LoadedLook& look);
    /// The same of another scene than what is shown, without looks; waits for the picture before.
    void draw(std::size_t cell, std::shared_ptr<const Shown> scene, const FrameSettings& settings);
    /// In eTransferSrcOptimal; null: nothing was drawn there yet.
    const gpu::Image* picture(std::size_t cell) const;

  private:
    void render(std::size_t cell, const FrameInputs& inputs, const FrameSettings& settings);

    const gpu::Device& device_;
    std::optional<GpuShown> scene_; ///< of the last picture, if it was of another
    std::vector<std::optional<gpu::Image>> cells_;
    LookSlot look_;
    Executor executor_;
};

} // namespace preview
