// The window itself, by GLFW: what a Vulkan device needs to draw in it.
#pragma once

#include "preview/gpu/device.h"
#include "preview/gpu/size.h"

#include <string>

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
    /// A device that can draw in windows: part of a name or a number, and whether under validation.
    gpu::DeviceOptions device_options(const std::string& wanted, bool validation) const;
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

} // namespace preview
