#include "preview/window/overlay.h"

#include "lutlib/error.h"

#include <imgui.h>
#include <imgui/backends/imgui_impl_vulkan.h>

namespace preview {

namespace {

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
    if (result < 0) {
        throw lutlib::Error("the window cannot be drawn: " +
                            vk::to_string(static_cast<vk::Result>(result)));
    }
}

} // namespace

Overlay::Overlay(const gpu::Device& device, vk::Format format)
    : device_(device), descriptors_(make_pool(device)), pass_(make_pass(device, format)) {
    start();
}

void Overlay::start() {
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = *device_.instance();
    info.PhysicalDevice = *device_.physical();
    info.Device = *device_.vk();
    info.QueueFamily = device_.queue_family();
    info.Queue = *device_.queue();
    info.DescriptorPool = *descriptors_;
    info.MinImageCount = 2;
    info.ImageCount = 3; // vertex buffers in turn, one more than frames in flight
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    info.CheckVkResultFn = &check;
    ImGui_ImplVulkan_Init(&info, *pass_);
    device_.run_once([](const vk::raii::CommandBuffer& commands) {
        ImGui_ImplVulkan_CreateFontsTexture(*commands);
    });
    ImGui_ImplVulkan_DestroyFontUploadObjects();
}

Overlay::~Overlay() {
    (*device_.vk()).waitIdle(*device_.vk().getDispatcher());
    ImGui_ImplVulkan_Shutdown();
}

void Overlay::take_fonts() {
    device_.vk().waitIdle();
    ImGui_ImplVulkan_Shutdown();
    start();
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

void Overlay::begin_frame() {
    ImGui_ImplVulkan_NewFrame();
}

void Overlay::record(const vk::raii::CommandBuffer& commands, std::uint32_t image) const {
    commands.beginRenderPass(
        vk::RenderPassBeginInfo(*pass_, *framebuffers_[image], {{0, 0}, extent_}),
        vk::SubpassContents::eInline);
    ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), *commands);
    commands.endRenderPass();
}

} // namespace preview
