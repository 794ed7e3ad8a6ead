#include "preview/window/window.h"

#include "lutlib/error.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>

namespace preview {

namespace {

/// Behind what failed.
std::string glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? std::string(": ") + text : std::string();
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

Window::Window(Size size) {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    handle_ = glfwCreateWindow(static_cast<int>(size.width), static_cast<int>(size.height),
                               "lutpreview", nullptr, nullptr);
    if (handle_ == nullptr) {
        throw lutlib::Error("cannot open a window" + glfw_error());
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
