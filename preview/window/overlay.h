// What Dear ImGui draws, onto a window's images with Vulkan, and small pictures among that.
#pragma once

#include "preview/gpu/swapchain.h"

struct ImDrawCmd;
struct ImDrawList;

namespace preview {

class ThumbnailCells;

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
    /// What was drawn since begin_frame(), over an image of the targets that stands in
    /// eTransferDstOptimal; leaves it ready to be presented. `thumbnails` may be null: none are.
    void record(const vk::raii::CommandBuffer& commands, const gpu::Swapchain& swapchain,
                std::uint32_t image, const ThumbnailCells* thumbnails) const;
    /// As panels::Thumbnails::draw, while record() runs. The picture is copied between two halves
    /// of the drawing: over what windows have drawn before, under what comes later, as popups do.
    static void draw_thumbnails(const ImDrawList* list, const ImDrawCmd* command);

  private:
    struct Recording;
    void start();
    void begin_pass(const vk::raii::CommandBuffer& commands, std::uint32_t image) const;

    const gpu::Device& device_;
    vk::raii::DescriptorPool descriptors_;
    vk::raii::RenderPass pass_;
    std::vector<vk::raii::Framebuffer> framebuffers_;
    vk::Extent2D extent_;
};

} // namespace preview
