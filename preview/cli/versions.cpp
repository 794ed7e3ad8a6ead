#include "preview/cli/versions.h"

#include "lutlib/version.h"
#include "terminal/versions.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <vulkan/vulkan.h>

namespace preview {

std::string versions(bool verbose) {
    std::uint32_t loader = VK_API_VERSION_1_0;
    vkEnumerateInstanceVersion(&loader);
    int major = 0, minor = 0, revision = 0;
    glfwGetVersion(&major, &minor, &revision);
    return fmt::format("lutpreview {}\nVulkan loader {}.{}.{}\nGLFW {}.{}.{}\nDear ImGui {}\n{}{}",
                       lutlib::version, VK_API_VERSION_MAJOR(loader), VK_API_VERSION_MINOR(loader),
                       VK_API_VERSION_PATCH(loader), major, minor, revision, ImGui::GetVersion(),
                       terminal::loaded_versions(), verbose ? terminal::holding_line() : "");
}

} // namespace preview
