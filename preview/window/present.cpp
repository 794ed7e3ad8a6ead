#include "preview/window/present.h"

namespace preview {

void record_present(const vk::raii::CommandBuffer& commands, std::span<const Placed> pictures,
                    vk::Image target) {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    constexpr auto layout = vk::ImageLayout::eTransferDstOptimal;
    const vk::ImageSubresourceRange all(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
    const vk::ImageMemoryBarrier2 to_clear(Stage::eAllCommands, {}, Stage::eAllTransfer,
                                           Access::eTransferWrite, vk::ImageLayout::eUndefined,
                                           layout, VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED,
                                           target, all);
    commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, to_clear));
    commands.clearColorImage(target, layout, vk::ClearColorValue(std::array{0.F, 0.F, 0.F, 1.F}),
                             all);
    const vk::MemoryBarrier2 to_blit(Stage::eAllTransfer, Access::eTransferWrite,
                                     Stage::eAllTransfer, Access::eTransferWrite);
    commands.pipelineBarrier2(vk::DependencyInfo({}, to_blit));
    const vk::ImageSubresourceLayers layers(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
    for (const Placed& placed : pictures) {
        const ImageDesc& desc = placed.picture->desc();
        const vk::Offset3D size(static_cast<int>(desc.width), static_cast<int>(desc.height), 1);
        const std::array from{vk::Offset3D(0, 0, 0), size};
        const std::array to{vk::Offset3D(placed.place, 0),
                            vk::Offset3D(placed.place.x + size.x, placed.place.y + size.y, 1)};
        commands.blitImage(placed.picture->vk(), vk::ImageLayout::eTransferSrcOptimal, target,
                           layout, vk::ImageBlit(layers, from, layers, to), vk::Filter::eNearest);
    }
}

} // namespace preview
