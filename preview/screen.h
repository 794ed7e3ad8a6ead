// Everything of the window that lives on the GPU, from the device on. When the device is lost, all
// of it is made anew from what the program holds.
#pragma once

#include "preview/graph/execute.h"
#include "preview/look_slot.h"
#include "preview/overlay.h"
#include "preview/shown.h"
#include "preview/window.h"

#include <array>
#include <optional>

namespace preview {

inline constexpr int frames_in_flight = 2;

struct Screen {
    /// Shows nothing yet, and no looks. Throws lutlib::Error when the device cannot be had.
    Screen(const Window& window, const Options& options);
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    /// Replaces what is shown, or throws and leaves it.
    void show(std::shared_ptr<const Shown> next);
    /// Makes the images anew for the window's size.
    void resize(const Window& window);

    gpu::Device device;
    gpu::Swapchain swapchain;
    Executor executor;
    std::optional<GpuShown> shown;
    std::array<LookSlot, 2> looks;
    Overlay overlay; ///< the last: its end waits for the GPU
};

/// Whether the error says that the device, or its hold of the window, is lost.
bool is_lost(const vk::SystemError& error);

} // namespace preview
