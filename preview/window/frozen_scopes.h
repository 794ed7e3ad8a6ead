// What the scopes counted at one moment, which they show while the picture goes on.
#pragma once

#include "preview/frame/settings.h"
#include "preview/graph/execute.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace preview {

/// A device's copies of what is frozen. They live with its screen.
using FrozenCounts = std::array<std::optional<gpu::Buffer>, scopes.size()>;

class FrozenScopes {
  public:
    /// What the executor's last frame has counted, with FrameSettings::keeps_scopes. Waits for all
    /// frames, and drops `copies`. Whether anything was counted.
    bool take(Executor& executor, const FrameHandles& handles, FrozenCounts& copies);
    void thaw() { is_frozen_ = false; }
    bool is_frozen() const { return is_frozen_; }

    /// For a frame on this device; nothing while nothing is frozen. Makes copies that are missing.
    std::array<KeptScope, scopes.size()> on(const gpu::Device& device, FrozenCounts& copies) const;

  private:
    struct Counted {
        std::vector<std::byte> counts;
        KeptScope shape;
    };
    std::array<Counted, scopes.size()> counted_;
    bool is_frozen_ = false;
};

} // namespace preview
