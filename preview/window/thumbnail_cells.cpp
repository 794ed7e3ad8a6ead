#include "preview/window/thumbnail_cells.h"

#include "preview/frame/frame.h"
#include "preview/gpu/commands.h"

namespace preview {

namespace {

gpu::Image make_cell(const gpu::Device& device, Size size) {
    return {device,
            {Format::rgba8, size.width, size.height},
            vk::ImageUsageFlagBits::eTransferDst | vk::ImageUsageFlagBits::eTransferSrc};
}

void copy_into(const vk::raii::CommandBuffer& commands, const gpu::Image& from,
               const gpu::Image& cell) {
    using Layout = vk::ImageLayout;
    gpu::move_layout(commands, cell, Layout::eUndefined, Layout::eTransferDstOptimal);
    const vk::ImageSubresourceLayers layers(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
    const vk::Extent3D extent(cell.desc().width, cell.desc().height, 1);
    commands.copyImage(from.vk(), Layout::eTransferSrcOptimal, cell.vk(),
                       Layout::eTransferDstOptimal, vk::ImageCopy(layers, {}, layers, {}, extent));
    gpu::move_layout(commands, cell, Layout::eTransferDstOptimal, Layout::eTransferSrcOptimal);
}

} // namespace

ThumbnailCells::ThumbnailCells(const gpu::Device& device)
    : device_(device), cells_(count), look_(device), executor_(device, 1) {}

void ThumbnailCells::draw(std::size_t cell, FrameInputs inputs, const FrameSettings& settings,
                          const LoadedLook& look) {
    look_.set(look);
    inputs.look_a = nullptr;
    inputs.look_b = look_.look();
    render(cell, inputs, settings);
}

void ThumbnailCells::draw(std::size_t cell, std::shared_ptr<const Shown> scene,
                          const FrameSettings& settings) {
    executor_.wait();
    scene_.reset();
    scene_.emplace(device_, std::move(scene));
    render(cell, scene_->inputs(), settings);
}

void ThumbnailCells::render(std::size_t cell, const FrameInputs& inputs,
                            const FrameSettings& settings) {
    Graph graph;
    const FrameHandles handles = build_frame(graph, inputs, settings);
    std::optional<gpu::Image>& image = cells_[cell];
    const Size size = settings.output;
    if (!image || image->desc().width != size.width || image->desc().height != size.height) {
        device_.vk().waitIdle(); // a frame may still show it
        image.emplace(make_cell(device_, size));
    }
    FrameEnd end;
    end.record = [&](const vk::raii::CommandBuffer& commands) {
        copy_into(commands, executor_.image(handles.output), *image);
    };
    executor_.render(graph, end);
}

const gpu::Image* ThumbnailCells::picture(std::size_t cell) const {
    return cell < cells_.size() && cells_[cell] ? &*cells_[cell] : nullptr;
}

} // namespace preview
