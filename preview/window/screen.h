// Everything of the window that lives on the GPU, from the device on. When the device is lost, all
// of it is made anew from what the program holds.
#pragma once

#include "preview/frame/shown.h"
#include "preview/graph/execute.h"
#include "preview/look/look_slot.h"
#include "preview/look/still.h"
#include "preview/window/frozen_scopes.h"
#include "preview/window/overlay.h"
#include "preview/window/thumbnail_cells.h"
#include "preview/window/window.h"

#include <array>
#include <optional>
#include <string>

namespace preview {

inline constexpr int frames_in_flight = 2;

struct Screen {
    /// Shows nothing yet, and no looks. Throws lutlib::Error when the device cannot be had.
    Screen(const Window& window, const gpu::DeviceOptions& device_options);
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    /// Replaces what is shown, or throws and leaves it.
    void show(std::shared_ptr<const Shown> next);
    /// Makes the images anew for the window's size.
    void resize(const Window& window);
    /// Null: none. Waits for the GPU where it is another; throws and leaves it where the GPU has no
    /// room.
    void set_still(std::size_t side, std::shared_ptr<const Still> still);

    gpu::Device device;
    gpu::Swapchain swapchain;
    Executor executor;
    std::optional<GpuShown> shown;
    std::array<LookSlot, 2> looks;
    struct GpuStill {
        std::shared_ptr<const Still> still;
        std::optional<GpuPicture> picture;
    };
    std::array<GpuStill, 2> stills;
    FrozenCounts frozen;
    std::optional<ThumbnailCells> thumbnails; ///< once one was asked for
    Overlay overlay;                          ///< the last: its end waits for the GPU
};

/// Whether the error says that the device, or its hold of the window, is lost.
bool is_lost(const vk::SystemError& error);

/// Decides whether a lost device is worth another try.
class Recovery {
  public:
    /// A screen that is lost again before so many frames were drawn will not do.
    static constexpr int frames_of_proof = 10;

    /// What to tell a person before everything is made anew. Throws lutlib::Error when the last try
    /// has not proved itself.
    std::string lost(const vk::SystemError& error);
    /// A frame was drawn.
    void drew() { unproved_ -= unproved_ > 0 ? 1 : 0; }

  private:
    int unproved_ = 0; ///< frames that the newest screen still has to draw
};

} // namespace preview
