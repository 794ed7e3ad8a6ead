#include "preview/gpu/commands.h"

#include "lutlib/error.h"

namespace preview::gpu {

Commands::Commands(const Device& device)
    : device_(&device),
      pool_(device.vk(),
            vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eResetCommandBuffer,
                                      device.queue_family())),
      fence_(device.vk(), vk::FenceCreateInfo(vk::FenceCreateFlagBits::eSignaled)) {
    vk::raii::CommandBuffers made(device.vk(), {*pool_, vk::CommandBufferLevel::ePrimary, 1});
    buffer_ = std::move(made.front());
}

const vk::raii::CommandBuffer& Commands::begin() {
    wait();
    buffer_.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    return buffer_;
}

void Commands::submit(std::span<const vk::SemaphoreSubmitInfo> waits,
                      std::span<const vk::SemaphoreSubmitInfo> signals) {
    buffer_.end();
    device_->vk().resetFences(*fence_);
    const vk::CommandBufferSubmitInfo commands(*buffer_);
    vk::SubmitInfo2 info({}, {}, commands, {});
    info.setWaitSemaphoreInfoCount(static_cast<std::uint32_t>(waits.size()));
    info.setPWaitSemaphoreInfos(waits.data());
    info.setSignalSemaphoreInfoCount(static_cast<std::uint32_t>(signals.size()));
    info.setPSignalSemaphoreInfos(signals.data());
    device_->queue().submit2(info, *fence_);
}

void Commands::wait() const {
    if (device_->vk().waitForFences(*fence_, VK_TRUE, UINT64_MAX) != vk::Result::eSuccess) {
        throw lutlib::Error("the GPU did not finish");
    }
}

vk::MemoryBarrier2 memory_barrier(Scope from, Scope to) {
    return {from.stages, from.memory, to.stages, to.memory};
}

vk::ImageMemoryBarrier2 image_barrier(vk::Image image, vk::ImageAspectFlags aspect, Scope from,
                                      Scope to, vk::ImageLayout old_layout,
                                      vk::ImageLayout new_layout) {
    return {from.stages,
            from.memory,
            to.stages,
            to.memory,
            old_layout,
            new_layout,
            VK_QUEUE_FAMILY_IGNORED,
            VK_QUEUE_FAMILY_IGNORED,
            image,
            {aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS}};
}

void record(const vk::raii::CommandBuffer& commands, const vk::MemoryBarrier2& barrier) {
    commands.pipelineBarrier2(vk::DependencyInfo({}, barrier));
}

void record(const vk::raii::CommandBuffer& commands, const vk::ImageMemoryBarrier2& barrier) {
    commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier));
}

} // namespace preview::gpu
