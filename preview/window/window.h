// The window itself, by GLFW: what a Vulkan device needs to draw in it.
#pragma once

#include "preview/gpu/device.h"
#include "preview/gpu/size.h"
#include "preview/window/window_memory.h"

#include <optional>
#include <string>

struct GLFWwindow;

namespace preview {

/// At a content scale of 1, before anybody has changed it.
inline constexpr Size usual_window_size{1600, 900};

/// GLFW's library and one window. Throws lutlib::Error when none can be had.
class Window {
  public:
    /// Of exactly this size; else where it was before, else of usual_window_size times the content
    /// scale, in both cases within what the monitors leave for windows.
    Window(std::optional<Size> exact, const WindowMemory& memory);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return handle_; }
    /// In pixels; 0x0 while it is minimised.
    Size framebuffer_size() const;
    /// How many pixels what is one pixel large at 96 dpi shall have; as the desktop has it.
    float content_scale() const;
    /// Puts place and size into `memory`, or, of a maximised window, that it is maximised.
    void tell_place(WindowMemory& memory) const;
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
    void place(std::optional<Size> exact, const WindowMemory& memory) const;
    Library library_;
    GLFWwindow* handle_ = nullptr;
};

} // namespace preview
