// What studies look at: the scene or picture that the options name, with its settings and looks.
#pragma once

#include "preview/check/situation.h"
#include "preview/cli/options.h"
#include "preview/look/gpu_look.h"

#include <optional>

namespace preview {

/// The situation, without looks. Throws lutlib::Error, and UsageError.
Situation situation_of(const Options& options, const gpu::Device& device);

/// The looks of both sides, as the frame's passes read them; nothing of one that would change
/// nothing. Must outlive the situations that name them.
struct StudiedLooks {
    StudiedLooks(const gpu::Device& device, const Options& options, bool has_light);
    void put_into(Situation& situation) const;

    std::optional<GpuLook> a, b;
};

} // namespace preview
