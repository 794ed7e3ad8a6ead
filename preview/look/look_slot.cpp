#include "preview/look/look_slot.h"

#include "lutlib/error.h"

#include <algorithm>
#include <cstring>

namespace preview {

namespace {

constexpr std::uint32_t uploads_in_flight = 3;

bool same_shape(const Texels& a, const Texels& b) {
    return a.desc == b.desc && a.bytes.empty() == b.bytes.empty();
}

/// The same with one byte for each image that there is.
LookData shape_of(const LookData& data) {
    LookData shape;
    shape.lookup = data.lookup;
    const auto keep = [](const Texels& texels) {
        return Texels{texels.desc, std::vector<std::byte>(texels.bytes.empty() ? 0 : 1)};
    };
    shape.picture = keep(data.picture);
    shape.volume = keep(data.volume);
    shape.shaper = keep(data.shaper);
    return shape;
}

void barrier(const vk::raii::CommandBuffer& commands, const gpu::Image& image, vk::ImageLayout from,
             vk::ImageLayout to) {
    constexpr auto stage = vk::PipelineStageFlagBits2::eAllCommands;
    constexpr auto access = vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite;
    const vk::ImageMemoryBarrier2 change(stage, access, stage, access, from, to,
                                         VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED,
                                         image.vk(), image.range());
    commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, change));
}

} // namespace

LookSlot::LookSlot(const gpu::Device& device)
    : device_(device),
      pool_(device.vk(),
            vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eResetCommandBuffer,
                                      device.queue_family())) {
    vk::raii::CommandBuffers commands(
        device.vk(), {*pool_, vk::CommandBufferLevel::ePrimary, uploads_in_flight});
    for (vk::raii::CommandBuffer& buffer : commands) {
        Upload upload;
        upload.commands = std::move(buffer);
        upload.fence = {device.vk(), vk::FenceCreateInfo(vk::FenceCreateFlagBits::eSignaled)};
        uploads_.push_back(std::move(upload));
    }
}

void LookSlot::set(const LoadedLook& look) {
    shown_ = look.skip_reason.empty();
    if (!shown_)
        return;
    const LookData& data = look.data;
    if (look_ && data.lookup == shape_.lookup && same_shape(data.picture, shape_.picture) &&
        same_shape(data.volume, shape_.volume) && same_shape(data.shaper, shape_.shaper)) {
        copy(data);
        look_->block = data.block;
        return;
    }
    device_.vk().waitIdle();
    look_.emplace(device_, data);
    shape_ = shape_of(data);
}

void LookSlot::copy(const LookData& data) {
    turn_ = (turn_ + 1) % uploads_.size();
    Upload& upload = uploads_[turn_];
    if (device_.vk().waitForFences(*upload.fence, VK_TRUE, UINT64_MAX) != vk::Result::eSuccess)
        throw lutlib::Error("the GPU did not finish");
    device_.vk().resetFences(*upload.fence);
    upload.staging.clear();
    upload.commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    const auto add = [&](const Texels& texels, const std::optional<gpu::Image>& image) {
        if (!image)
            return;
        const gpu::Buffer& staging = upload.staging.emplace_back(
            device_, texels.bytes.size(), vk::BufferUsageFlagBits::eTransferSrc,
            gpu::BufferMemory::upload);
        std::memcpy(staging.mapped().data(), texels.bytes.data(), texels.bytes.size());
        barrier(upload.commands, *image, vk::ImageLayout::eReadOnlyOptimal,
                vk::ImageLayout::eTransferDstOptimal);
        const ImageDesc& desc = image->desc();
        const vk::BufferImageCopy whole(0, 0, 0, {image->aspect(), 0, 0, std::max(desc.layers, 1U)},
                                        {0, 0, 0},
                                        {desc.width, desc.height, std::max(desc.depth, 1U)});
        upload.commands.copyBufferToImage(staging.vk(), image->vk(),
                                          vk::ImageLayout::eTransferDstOptimal, whole);
        barrier(upload.commands, *image, vk::ImageLayout::eTransferDstOptimal,
                vk::ImageLayout::eReadOnlyOptimal);
    };
    add(data.picture, look_->picture);
    add(data.volume, look_->volume);
    add(data.shaper, look_->shaper);
    upload.commands.end();
    const vk::CommandBufferSubmitInfo commands(*upload.commands);
    device_.queue().submit2(vk::SubmitInfo2({}, {}, commands, {}), *upload.fence);
}

} // namespace preview
