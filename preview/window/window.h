// The window itself, by GLFW: what a Vulkan device needs to draw in it.
#pragma once

#include "preview/gpu/device.h"
#include "preview/cli/options.h"
#include "preview/passes/pass.h"

struct GLFWwindow;

namespace preview {

/// GLFW's library and one window. Throws lutlib::Error when none can be had.
class Window {
  public:
    explicit Window(Size size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return handle_; }
    /// In pixels; 0x0 while it is minimised.
    Size framebuffer_size() const;
    /// A device that can draw in windows, as the options want it.
    gpu::DeviceOptions device_options(const Options& options) const;
    /// To be owned by a swapchain. Throws lutlib::Error.
    VkSurfaceKHR make_surface(const gpu::Device& device) const;

  private:
    struct Library {
        Library();
        ~Library();
        Library(const Library&) = delete;
        Library& operator=(const Library&) = delete;
    };
    Library library_;
    GLFWwindow* handle_ = nullptr;
};

/// The options' size, or that of a window nobody asked a size for.
Size window_size(const Options& options);

} // namespace preview
