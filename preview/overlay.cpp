#include "preview/overlay.h"

#include "lutlib/error.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_vulkan.h>

#include <filesystem>

namespace preview {

namespace {

constexpr const char* font_path = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr float font_size = 14;

vk::raii::DescriptorPool make_pool(const gpu::Device& device) {
    const vk::DescriptorPoolSize sizes(vk::DescriptorType::eCombinedImageSampler, 16);
    return {device.vk(), vk::DescriptorPoolCreateInfo(
                             vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 16, sizes)};
}

vk::raii::RenderPass make_pass(const gpu::Device& device, vk::Format format) {
    const vk::AttachmentDescription color(
        {}, format, vk::SampleCountFlagBits::e1, vk::AttachmentLoadOp::eLoad,
        vk::AttachmentStoreOp::eStore, vk::AttachmentLoadOp::eDontCare,
        vk::AttachmentStoreOp::eDontCare, vk::ImageLayout::eTransferDstOptimal,
        vk::ImageLayout::ePresentSrcKHR);
    const vk::AttachmentReference reference(0, vk::ImageLayout::eColorAttachmentOptimal);
    const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, reference);
    using Stage = vk::PipelineStageFlagBits;
    using Access = vk::AccessFlagBits;
    const vk::SubpassDependency dependency(
        VK_SUBPASS_EXTERNAL, 0, Stage::eTransfer, Stage::eColorAttachmentOutput,
        Access::eTransferWrite, Access::eColorAttachmentRead | Access::eColorAttachmentWrite);
    return {device.vk(), vk::RenderPassCreateInfo({}, color, subpass, dependency)};
}

void check(VkResult result) {
    if (result < 0)
        throw lutlib::Error("the window cannot be drawn: " +
                            vk::to_string(static_cast<vk::Result>(result)));
}

} // namespace

Overlay::Overlay(const gpu::Device& device, GLFWwindow* window, vk::Format format,
                 std::string settings_path)
    : device_(device), window_(window), mouse_x_(ui::far_away), mouse_y_(ui::far_away),
      settings_path_(std::move(settings_path)), descriptors_(make_pool(device)),
      pass_(make_pass(device, format)) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = settings_path_.empty() ? nullptr : settings_path_.c_str();
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    float scale = 1;
    glfwGetWindowContentScale(window, &scale, nullptr);
    style.ScaleAllSizes(scale);
    load_font(scale);

    ImGui_ImplGlfw_InitForVulkan(window, false);
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = *device.instance();
    info.PhysicalDevice = *device.physical();
    info.Device = *device.vk();
    info.QueueFamily = device.queue_family();
    info.Queue = *device.queue();
    info.DescriptorPool = *descriptors_;
    info.MinImageCount = 2;
    info.ImageCount = 3; // vertex buffers in turn, one more than frames in flight
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    info.CheckVkResultFn = &check;
    ImGui_ImplVulkan_Init(&info, *pass_);
    device.run_once([](const vk::raii::CommandBuffer& commands) {
        ImGui_ImplVulkan_CreateFontsTexture(*commands);
    });
    ImGui_ImplVulkan_DestroyFontUploadObjects();
}

Overlay::~Overlay() {
    (*device_.vk()).waitIdle(*device_.vk().getDispatcher());
    ImGui_ImplVulkan_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Overlay::load_font(float scale) {
    ImGuiIO& io = ImGui::GetIO();
    std::error_code missing;
    if (std::filesystem::exists(font_path, missing) &&
        io.Fonts->AddFontFromFileTTF(font_path, font_size * scale) != nullptr)
        return;
    io.Fonts->AddFontDefault();
    notice_ = std::string("the font ") + font_path +
              " is missing (Debian: fonts-dejavu-core); a built-in one stands in";
}

void Overlay::set_targets(const gpu::Swapchain& swapchain) {
    framebuffers_.clear();
    extent_ = swapchain.extent();
    for (std::uint32_t i = 0; i < swapchain.count(); ++i) {
        const vk::ImageView view = swapchain.view(i);
        framebuffers_.emplace_back(
            device_.vk(),
            vk::FramebufferCreateInfo({}, *pass_, view, extent_.width, extent_.height, 1));
    }
}

void Overlay::feed(const ui::InputEvent& event) {
    using Kind = ui::InputEvent::Kind;
    ImGuiIO& io = ImGui::GetIO();
    switch (event.kind) {
    case Kind::move:
        mouse_x_ = event.x;
        mouse_y_ = event.y;
        break;
    case Kind::wheel:
        io.MouseWheelH += event.x;
        io.MouseWheel += event.y;
        break;
    case Kind::button:
        if (const auto index = static_cast<std::size_t>(event.code); index < buttons_.size())
            buttons_[index] = event.down;
        break;
    case Kind::key:
        ImGui_ImplGlfw_KeyCallback(window_, event.code, event.scancode,
                                   event.down ? GLFW_PRESS : GLFW_RELEASE, event.modifiers);
        break;
    case Kind::character:
        io.AddInputCharacter(static_cast<unsigned>(event.code));
        break;
    }
}

void Overlay::begin_frame(const std::vector<ui::InputEvent>& events) {
    for (const ui::InputEvent& event : events)
        feed(event);
    ImGui_ImplVulkan_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    // The backend looks at where the mouse is now; the events tell where it was.
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {mouse_x_, mouse_y_};
    for (std::size_t i = 0; i < buttons_.size(); ++i)
        io.MouseDown[i] = buttons_[i];
    ImGui::NewFrame();
}

void Overlay::record(const vk::raii::CommandBuffer& commands, std::uint32_t image) const {
    commands.beginRenderPass(
        vk::RenderPassBeginInfo(*pass_, *framebuffers_[image], {{0, 0}, extent_}),
        vk::SubpassContents::eInline);
    ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), *commands);
    commands.endRenderPass();
}

} // namespace preview
