#include "preview/window/overlay.h"

#include "lutlib/error.h"
#include "preview/gpu/commands.h"
#include "preview/panels/thumbnail.h"
#include "preview/window/thumbnail_cells.h"
#include "preview/window/thumbnail_place.h"

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
    if (result == VK_ERROR_DEVICE_LOST) {
        throw vk::DeviceLostError("drawing the panels");
    }
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
    device_.vk().getDispatcher()->vkDeviceWaitIdle(*device_.vk()); // lost or not
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

struct Overlay::Recording {
    const Overlay& overlay;
    const vk::raii::CommandBuffer& commands;
    vk::Image target;
    std::uint32_t image = 0;
    const ThumbnailCells* thumbnails = nullptr;
};

void Overlay::begin_pass(const vk::raii::CommandBuffer& commands, std::uint32_t image) const {
    commands.beginRenderPass(
        vk::RenderPassBeginInfo(*pass_, *framebuffers_[image], {{0, 0}, extent_}),
        vk::SubpassContents::eInline);
}

void Overlay::record(const vk::raii::CommandBuffer& commands, const gpu::Swapchain& swapchain,
                     std::uint32_t image, const ThumbnailCells* thumbnails) const {
    Recording recording{*this, commands, swapchain.image(image), image, thumbnails};
    ImGui::GetIO().UserData = &recording;
    begin_pass(commands, image);
    ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), *commands);
    commands.endRenderPass();
    ImGui::GetIO().UserData = nullptr;
}

void Overlay::draw_thumbnails(const ImDrawList* /*list*/, const ImDrawCmd* command) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto* const recording = static_cast<const Recording*>(io.UserData);
    if (recording == nullptr || recording->thumbnails == nullptr) {
        return;
    }
    const vk::raii::CommandBuffer& commands = recording->commands;
    commands.endRenderPass();
    using Layout = vk::ImageLayout;
    constexpr auto color = vk::ImageAspectFlagBits::eColor;
    constexpr gpu::Scope drawing{vk::PipelineStageFlagBits2::eColorAttachmentOutput,
                                 vk::AccessFlagBits2::eColorAttachmentWrite};
    gpu::record(commands, gpu::image_barrier(recording->target, color, drawing, gpu::transfer_write,
                                             Layout::ePresentSrcKHR, Layout::eTransferDstOptimal));
    const vk::ImageSubresourceLayers layers(color, 0, 0, 1);
    const Size target{recording->overlay.extent_.width, recording->overlay.extent_.height};
    for (const panels::PlacedThumbnail& placed :
         *static_cast<const panels::ThumbnailGroup*>(command->UserCallbackData)) {
        const gpu::Image* const picture = recording->thumbnails->picture(placed.cell);
        if (picture == nullptr) {
            continue;
        }
        const ThumbnailPlace place =
            place_in(placed, {io.DisplayFramebufferScale.x, io.DisplayFramebufferScale.y},
                     {picture->desc().width, picture->desc().height}, target);
        if (place.is_empty()) {
            continue;
        }
        const auto corners = [](const PixelBox& box) {
            return std::array{vk::Offset3D(box.left, box.top, 0),
                              vk::Offset3D(box.right, box.bottom, 1)};
        };
        commands.blitImage(picture->vk(), Layout::eTransferSrcOptimal, recording->target,
                           Layout::eTransferDstOptimal,
                           vk::ImageBlit(layers, corners(place.from), layers, corners(place.to)),
                           vk::Filter::eLinear);
    }
    recording->overlay.begin_pass(commands, recording->image);
}

} // namespace preview
