#include "preview/window/screen.h"

#include "lutlib/error.h"

namespace preview {

Screen::Screen(const Window& window, const gpu::DeviceOptions& device_options)
    : device(device_options), swapchain(device, window.make_surface(device)),
      executor(device, frames_in_flight), looks{LookSlot(device), LookSlot(device)}, thumbnails(),
      overlay(device, swapchain.format()) {}

void Screen::show(std::shared_ptr<const Shown> next) {
    GpuShown made(device, std::move(next));
    device.vk().waitIdle();
    shown.emplace(std::move(made));
}

void Screen::resize(const Window& window) {
    const Size size = window.framebuffer_size();
    swapchain.resize(size.width, size.height);
    overlay.set_targets(swapchain);
}

void Screen::set_still(std::size_t side, std::shared_ptr<const Still> still) {
    GpuStill& now = stills[side];
    if (now.still == still) {
        return;
    }
    GpuStill next;
    if (still) {
        next.picture.emplace(device, still->size, still->rgba, true);
        next.still = std::move(still);
    }
    device.vk().waitIdle();
    now = std::move(next);
}

bool is_lost(const vk::SystemError& error) {
    return error.code() == vk::Result::eErrorDeviceLost ||
           error.code() == vk::Result::eErrorSurfaceLostKHR;
}

std::string Recovery::lost(const vk::SystemError& error) {
    if (unproved_ > 0) {
        throw lutlib::Error(std::string("the GPU was lost twice: ") + error.what() +
                            "; choose another with --device, or render with --headless");
    }
    unproved_ = frames_of_proof;
    return std::string("the GPU was lost, and everything on it was made anew: ") + error.what();
}

} // namespace preview
