#include "preview/window/present.h"

#include "preview/gpu/commands.h"
#include "preview/passes/magnify.h"

namespace preview {

void record_present(const vk::raii::CommandBuffer& commands, std::span<const Placed> pictures,
                    vk::Image target) {
    constexpr auto layout = vk::ImageLayout::eTransferDstOptimal;
    constexpr auto color = vk::ImageAspectFlagBits::eColor;
    const gpu::Scope whoever_had_it{vk::PipelineStageFlagBits2::eAllCommands, {}};
    gpu::record(commands, gpu::image_barrier(target, color, whoever_had_it, gpu::transfer_write,
                                             vk::ImageLayout::eUndefined, layout));
    const vk::ImageSubresourceRange all(color, 0, 1, 0, 1);
    commands.clearColorImage(
        target, layout,
        vk::ClearColorValue(std::array{surround_code, surround_code, surround_code, 1.F}), all);
    gpu::record(commands, gpu::memory_barrier(gpu::transfer_write, gpu::transfer_write));
    const vk::ImageSubresourceLayers layers(color, 0, 0, 1);
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
