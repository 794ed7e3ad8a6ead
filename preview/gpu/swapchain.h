// The images of a window, to draw into and show.
#pragma once

#include "preview/gpu/device.h"

#include <optional>
#include <vector>

namespace preview::gpu {

class Swapchain {
  public:
    /// Takes over the surface. Throws lutlib::Error when the device cannot show pictures on it.
    Swapchain(const Device& device, VkSurfaceKHR surface);

    /// Makes the images anew for a window of that size, after waiting for the GPU; a surface that
    /// has a size of its own decides.
    void resize(std::uint32_t width, std::uint32_t height);

    /// The next image to draw into, or none: resize() it first.
    std::optional<std::uint32_t> acquire();
    /// Shows the image. False: resize() before the next one.
    bool present(std::uint32_t image);

    /// What a frame's commands wait for before they write the acquired image, and signal after.
    vk::SemaphoreSubmitInfo acquired() const;
    vk::SemaphoreSubmitInfo finished(std::uint32_t image) const;

    vk::Format format() const { return format_.format; }
    vk::Extent2D extent() const { return extent_; }
    vk::Image image(std::uint32_t index) const { return images_[index]; }
    vk::ImageView view(std::uint32_t index) const { return *views_[index]; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(images_.size()); }

  private:
    // One more than the frames in flight: a frame's semaphore is waited for before its turn comes.
    static constexpr std::size_t acquire_count = 3;

    const Device& device_;
    vk::raii::SurfaceKHR surface_;
    vk::SurfaceFormatKHR format_;
    vk::raii::SwapchainKHR swapchain_ = nullptr;
    vk::Extent2D extent_;
    std::vector<vk::Image> images_;
    std::vector<vk::raii::ImageView> views_;
    std::vector<vk::raii::Semaphore> acquired_; ///< by turn
    std::vector<vk::raii::Semaphore> finished_; ///< by image
    std::size_t turn_ = 0;
};

} // namespace preview::gpu
