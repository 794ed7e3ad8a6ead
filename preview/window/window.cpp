#include "preview/window/window.h"

#include "lutlib/error.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace preview {

namespace {

/// Behind what failed.
std::string glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? std::string(": ") + text : std::string();
}

/// What the monitors leave for windows, the first monitor's first; of no monitor nothing.
std::vector<DesktopArea> work_areas() {
    int count = 0;
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    std::vector<DesktopArea> out;
    for (int i = 0; i < count; ++i) {
        DesktopArea area;
        glfwGetMonitorWorkarea(monitors[i], &area.x, &area.y, &area.width, &area.height);
        if (area.width > 0 && area.height > 0) {
            out.push_back(area);
        }
    }
    return out;
}

FrameWidths frame_of(GLFWwindow* window) {
    FrameWidths out;
    glfwGetWindowFrameSize(window, &out.left, &out.top, &out.right, &out.bottom);
    return out;
}

} // namespace

Window::Library::Library() {
    if (glfwInit() != GLFW_TRUE) {
        throw lutlib::Error("cannot open a window" + glfw_error() +
                            "; --headless -o FILE renders without one");
    }
    if (glfwVulkanSupported() != GLFW_TRUE) {
        glfwTerminate();
        throw lutlib::Error("no Vulkan driver can draw in a window here; --headless -o FILE "
                            "renders without one");
    }
}

Window::Library::~Library() {
    glfwTerminate();
}

Window::Window(std::optional<Size> exact, const WindowMemory& memory) {
    const Size first = exact.value_or(usual_window_size);
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE); // till it has its place
    handle_ = glfwCreateWindow(static_cast<int>(first.width), static_cast<int>(first.height),
                               "lutpreview", nullptr, nullptr);
    if (handle_ == nullptr) {
        throw lutlib::Error("cannot open a window" + glfw_error());
    }
    place(exact, memory);
    glfwShowWindow(handle_);
}

void Window::place(std::optional<Size> exact, const WindowMemory& memory) const {
    const std::vector<DesktopArea> works = work_areas();
    if (exact || works.empty()) {
        return;
    }
    const FrameWidths frame = frame_of(handle_);
    const auto scaled = [scale = content_scale()](std::uint32_t size) {
        return static_cast<std::uint32_t>(std::lround(static_cast<float>(size) * scale));
    };
    const Size usual{scaled(usual_window_size.width), scaled(usual_window_size.height)};
    const DesktopArea area = memory.area ? area_again(*memory.area, frame, works)
                                         : first_area(usual, frame, works.front());
    glfwSetWindowSize(handle_, area.width, area.height);
    glfwSetWindowPos(handle_, area.x, area.y);
    if (memory.is_maximised) {
        glfwMaximizeWindow(handle_);
    }
}

float Window::content_scale() const {
    float scale = 1;
    glfwGetWindowContentScale(handle_, &scale, nullptr);
    return scale > 0 ? scale : 1;
}

void Window::tell_place(WindowMemory& memory) const {
    memory.is_maximised = glfwGetWindowAttrib(handle_, GLFW_MAXIMIZED) == GLFW_TRUE;
    const bool is_minimised = glfwGetWindowAttrib(handle_, GLFW_ICONIFIED) == GLFW_TRUE;
    if (memory.is_maximised || is_minimised) {
        return;
    }
    DesktopArea area;
    glfwGetWindowPos(handle_, &area.x, &area.y);
    glfwGetWindowSize(handle_, &area.width, &area.height);
    if (area.width > 0 && area.height > 0) {
        memory.area = area;
    }
}

Window::~Window() {
    glfwDestroyWindow(handle_);
}

Size Window::framebuffer_size() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(handle_, &width, &height);
    return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

gpu::DeviceOptions Window::device_options(const std::string& wanted, bool validation) const {
    gpu::DeviceOptions out;
    out.wanted = wanted;
    out.validation = validation;
    std::uint32_t count = 0;
    const char** const names = glfwGetRequiredInstanceExtensions(&count);
    out.instance_extensions.assign(names, names + count);
    out.device_extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    return out;
}

VkSurfaceKHR Window::make_surface(const gpu::Device& device) const {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    if (glfwCreateWindowSurface(*device.instance(), handle_, nullptr, &surface) != VK_SUCCESS) {
        throw lutlib::Error("cannot draw in the window: no Vulkan surface" + glfw_error());
    }
    return surface;
}

} // namespace preview
