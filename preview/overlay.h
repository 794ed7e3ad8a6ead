// Dear ImGui on a window's images: its input from GLFW, its drawing with Vulkan.
#pragma once

#include "preview/gpu/swapchain.h"
#include "preview/ui/input.h"

#include <array>
#include <string>
#include <vector>

struct GLFWwindow;

namespace preview {

class Overlay {
  public:
    /// `settings_path`: where the layout is remembered; empty: nowhere.
    Overlay(const gpu::Device& device, GLFWwindow* window, vk::Format format,
            std::string settings_path);
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// After every Swapchain::resize().
    void set_targets(const gpu::Swapchain& swapchain);
    /// With what happened since the last one.
    void begin_frame(const std::vector<ui::InputEvent>& events);
    /// What was drawn since begin_frame(), over an image that stands in eTransferDstOptimal; leaves
    /// it ready to be presented.
    void record(const vk::raii::CommandBuffer& commands, std::uint32_t image) const;

    /// What a person should know of the set-up; empty when all is well.
    const std::string& notice() const { return notice_; }

  private:
    void load_font(float scale);
    void feed(const ui::InputEvent& event);

    const gpu::Device& device_;
    GLFWwindow* window_;
    float mouse_x_, mouse_y_; ///< beyond the window when the mouse is
    std::array<bool, 5> buttons_{};
    std::string settings_path_, notice_;
    vk::raii::DescriptorPool descriptors_;
    vk::raii::RenderPass pass_;
    std::vector<vk::raii::Framebuffer> framebuffers_;
    vk::Extent2D extent_;
};

} // namespace preview
