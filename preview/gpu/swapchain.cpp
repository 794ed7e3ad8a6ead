#include "preview/gpu/swapchain.h"

#include "lutlib/error.h"

#include <algorithm>

namespace preview::gpu {

namespace {

// Codes go to the screen as they are: the finishing pass has encoded them.
vk::SurfaceFormatKHR choose_format(const std::vector<vk::SurfaceFormatKHR>& formats) {
    for (const vk::Format wanted : {vk::Format::eB8G8R8A8Unorm, vk::Format::eR8G8B8A8Unorm}) {
        for (const vk::SurfaceFormatKHR& format : formats) {
            if (format.format == wanted && format.colorSpace == vk::ColorSpaceKHR::eSrgbNonlinear) {
                return format;
            }
        }
    }
    throw lutlib::Error("this display does not take 8-bit sRGB pictures; render with --headless");
}

} // namespace

Swapchain::Swapchain(const Device& device, VkSurfaceKHR surface)
    : device_(device), surface_(device.instance(), surface) {
    if (device.physical().getSurfaceSupportKHR(device.queue_family(), *surface_) == VK_FALSE) {
        throw lutlib::Error("the device '" + device.name() +
                            "' cannot show pictures on this display; choose another with --device");
    }
    format_ = choose_format(device.physical().getSurfaceFormatsKHR(*surface_));
    for (std::size_t i = 0; i < acquire_count; ++i) {
        acquired_.emplace_back(device.vk(), vk::SemaphoreCreateInfo());
    }
}

void Swapchain::resize(std::uint32_t width, std::uint32_t height) {
    device_.vk().waitIdle();
    const auto can = device_.physical().getSurfaceCapabilitiesKHR(*surface_);
    extent_ = can.currentExtent;
    if (extent_.width == UINT32_MAX) {
        extent_ =
            vk::Extent2D(std::clamp(width, can.minImageExtent.width, can.maxImageExtent.width),
                         std::clamp(height, can.minImageExtent.height, can.maxImageExtent.height));
    }
    views_.clear();
    finished_.clear();
    images_.clear();
    if (extent_.width == 0 || extent_.height == 0) {
        return;
    }
    const std::uint32_t most = can.maxImageCount > 0 ? can.maxImageCount : UINT32_MAX;
    vk::SwapchainCreateInfoKHR info({}, *surface_, std::min(can.minImageCount + 1, most),
                                    format_.format, format_.colorSpace, extent_, 1,
                                    vk::ImageUsageFlagBits::eColorAttachment |
                                        vk::ImageUsageFlagBits::eTransferDst);
    info.preTransform = can.currentTransform;
    info.compositeAlpha = vk::CompositeAlphaFlagBitsKHR::eOpaque;
    info.presentMode = vk::PresentModeKHR::eFifo;
    info.clipped = VK_TRUE;
    info.oldSwapchain = *swapchain_;
    swapchain_ = vk::raii::SwapchainKHR(device_.vk(), info);
    for (const VkImage image : swapchain_.getImages()) {
        images_.emplace_back(image);
        views_.emplace_back(device_.vk(), vk::ImageViewCreateInfo(
                                              {}, image, vk::ImageViewType::e2D, format_.format, {},
                                              {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}));
        finished_.emplace_back(device_.vk(), vk::SemaphoreCreateInfo());
    }
}

std::optional<std::uint32_t> Swapchain::acquire() {
    if (images_.empty()) {
        return std::nullopt;
    }
    turn_ = (turn_ + 1) % acquire_count;
    try {
        return swapchain_.acquireNextImage(UINT64_MAX, *acquired_[turn_]).second;
    } catch (const vk::OutOfDateKHRError&) {
        return std::nullopt;
    }
}

bool Swapchain::present(std::uint32_t image) {
    try {
        const vk::PresentInfoKHR info(*finished_[image], *swapchain_, image);
        return device_.queue().presentKHR(info) == vk::Result::eSuccess;
    } catch (const vk::OutOfDateKHRError&) {
        return false;
    }
}

vk::SemaphoreSubmitInfo Swapchain::acquired() const {
    return {*acquired_[turn_], 0, vk::PipelineStageFlagBits2::eAllCommands};
}

vk::SemaphoreSubmitInfo Swapchain::finished(std::uint32_t image) const {
    return {*finished_[image], 0, vk::PipelineStageFlagBits2::eAllCommands};
}

} // namespace preview::gpu
