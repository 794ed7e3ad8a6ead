// What Dear ImGui draws, onto a window's images with Vulkan.
#pragma once

#include "preview/gpu/swapchain.h"

namespace preview {

class Overlay {
  public:
    /// The context (gui.h) must be there before.
    Overlay(const gpu::Device& device, vk::Format format);
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// Fonts have changed since.
    void take_fonts();
    /// After every Swapchain::resize().
    void set_targets(const gpu::Swapchain& swapchain);
    /// Before Gui::begin_frame().
    void begin_frame();
    /// What was drawn since begin_frame(), over an image that stands in eTransferDstOptimal; leaves
    /// it ready to be presented.
    void record(const vk::raii::CommandBuffer& commands, std::uint32_t image) const;

  private:
    void start();

    const gpu::Device& device_;
    vk::raii::DescriptorPool descriptors_;
    vk::raii::RenderPass pass_;
    std::vector<vk::raii::Framebuffer> framebuffers_;
    vk::Extent2D extent_;
};

} // namespace preview
