// Commands that are recorded again and again, and the barriers between them.
#pragma once

#include "preview/gpu/device.h"

#include <span>

namespace preview::gpu {

/// A command buffer with the fence of its last submission, in a pool of its own.
class Commands {
  public:
    explicit Commands(const Device& device);

    /// Waits for the last submission and begins anew.
    const vk::raii::CommandBuffer& begin();
    /// Ends what was begun and hands it to the device's queue.
    void submit(std::span<const vk::SemaphoreSubmitInfo> waits = {},
                std::span<const vk::SemaphoreSubmitInfo> signals = {});
    /// For the last submission, if there was one. Throws lutlib::Error when it does not end.
    void wait() const;
    /// Whether the last submission has ended.
    bool is_done() const { return fence_.getStatus() == vk::Result::eSuccess; }

  private:
    const Device* device_;
    vk::raii::CommandPool pool_;
    vk::raii::CommandBuffer buffer_ = nullptr;
    vk::raii::Fence fence_; ///< signalled from the start
};

/// Who writes or reads: one side of a barrier.
struct Scope {
    vk::PipelineStageFlags2 stages;
    vk::AccessFlags2 memory;
};
constexpr Scope everything{vk::PipelineStageFlagBits2::eAllCommands,
                           vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite};
constexpr Scope transfer_write{vk::PipelineStageFlagBits2::eAllTransfer,
                               vk::AccessFlagBits2::eTransferWrite};
constexpr Scope host_read{vk::PipelineStageFlagBits2::eHost, vk::AccessFlagBits2::eHostRead};

/// What `from` did is done and visible to `to`.
vk::MemoryBarrier2 memory_barrier(Scope from, Scope to);
/// The same for the whole of an image, which moves to another layout in between.
vk::ImageMemoryBarrier2 image_barrier(vk::Image image, vk::ImageAspectFlags aspect, Scope from,
                                      Scope to, vk::ImageLayout old_layout,
                                      vk::ImageLayout new_layout);

void record(const vk::raii::CommandBuffer& commands, const vk::MemoryBarrier2& barrier);
void record(const vk::raii::CommandBuffer& commands, const vk::ImageMemoryBarrier2& barrier);

} // namespace preview::gpu
