#include "preview/look/look_slot.h"

#include <cstring>

namespace preview {

namespace {

constexpr int uploads_in_flight = 3;

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

} // namespace

LookSlot::LookSlot(const gpu::Device& device) : device_(device) {
    for (int upload = 0; upload < uploads_in_flight; ++upload) {
        uploads_.push_back({gpu::Commands(device), {}});
    }
}

void LookSlot::set(const LoadedLook& look) {
    shown_ = look.skip_reason.empty();
    if (!shown_) {
        return;
    }
    const LookData& data = look.data;
    if (look_ && data.lookup == shape_.lookup && same_shape(data.picture, shape_.picture) &&
        same_shape(data.volume, shape_.volume) && same_shape(data.shaper, shape_.shaper)) {
        copy(data);
        look_->block = data.block;
        look_->stand(data);
        return;
    }
    device_.vk().waitIdle();
    look_.emplace(device_, data);
    shape_ = shape_of(data);
}

void LookSlot::copy(const LookData& data) {
    turn_ = (turn_ + 1) % uploads_.size();
    Upload& upload = uploads_[turn_];
    const vk::raii::CommandBuffer& commands = upload.commands.begin();
    upload.staging.clear();
    const auto add = [&](const Texels& texels, const std::optional<gpu::Image>& image) {
        if (!image) {
            return;
        }
        const gpu::Buffer& staging = upload.staging.emplace_back(
            device_, texels.bytes.size(), vk::BufferUsageFlagBits::eTransferSrc,
            gpu::BufferMemory::upload);
        std::memcpy(staging.mapped().data(), texels.bytes.data(), texels.bytes.size());
        gpu::move_layout(commands, *image, vk::ImageLayout::eReadOnlyOptimal,
                         vk::ImageLayout::eTransferDstOptimal);
        commands.copyBufferToImage(staging.vk(), image->vk(), vk::ImageLayout::eTransferDstOptimal,
                                   gpu::whole(*image));
        gpu::move_layout(commands, *image, vk::ImageLayout::eTransferDstOptimal,
                         vk::ImageLayout::eReadOnlyOptimal);
    };
    add(data.picture, look_->picture);
    add(data.volume, look_->volume);
    add(data.shaper, look_->shaper);
    upload.commands.submit();
}

} // namespace preview
