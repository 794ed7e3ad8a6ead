#include "preview/gpu/memory.h"

#include "lutlib/error.h"
#include "preview/gpu/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <stdexcept>

namespace preview::gpu {

namespace {

using MemoryBits = vk::MemoryPropertyFlagBits;

/// In the order of the enumeration Format.
constexpr vk::Format vk_formats[] = {
    vk::Format::eR8G8B8A8Unorm,
    vk::Format::eA2B10G10R10UnormPack32,
    vk::Format::eR16G16Uint,
    vk::Format::eR16G16B16A16Unorm,
    vk::Format::eR16G16B16A16Sfloat,
    vk::Format::eR32Sfloat,
    vk::Format::eR32Uint,
    vk::Format::eR32G32B32A32Sfloat,
    vk::Format::eD32Sfloat,
    vk::Format::eB10G11R11UfloatPack32,
};
static_assert(std::size(vk_formats) == std::size(formats));

std::uint64_t next_serial() {
    static std::atomic<std::uint64_t> serial{0};
    return ++serial;
}

void check_size(const Device& device, const ImageDesc& desc) {
    const std::uint32_t limit =
        desc.depth > 0 ? device.limits().maxImageDimension3D : device.limits().maxImageDimension2D;
    if (std::max({desc.width, desc.height, desc.depth}) > limit) {
        throw lutlib::Error(fmt::format("a picture of {}x{} is larger than this GPU's {}x{}",
                                        desc.width, desc.height, limit, limit));
    }
}

} // namespace

vk::BufferImageCopy whole(const Image& image) {
    const ImageDesc& desc = image.desc();
    return {0,         0,
            0,         {image.aspect(), 0, 0, std::max(desc.layers, 1U)},
            {0, 0, 0}, {desc.width, desc.height, std::max(desc.depth, 1U)}};
}

void move_layout(const vk::raii::CommandBuffer& commands, const Image& image, vk::ImageLayout from,
                 vk::ImageLayout to) {
    record(commands, image_barrier(image.vk(), image.aspect(), everything, everything, from, to));
}

vk::Format vk_format(Format format) {
    return vk_formats[static_cast<std::size_t>(format)];
}

Image Image::unbound(const Device& device, const ImageDesc& desc, vk::ImageUsageFlags usage) {
    check_size(device, desc);
    Image image;
    image.device_ = &device;
    image.desc_ = desc;
    image.usage_ = usage;
    image.aspect_ =
        info(desc.format).depth ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
    image.serial_ = next_serial();
    const vk::ImageCreateInfo create(
        {}, desc.depth > 0 ? vk::ImageType::e3D : vk::ImageType::e2D, vk_format(desc.format),
        {desc.width, desc.height, std::max(desc.depth, 1U)}, 1, std::max(desc.layers, 1U),
        vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal, usage);
    image.image_ = {device.vk(), create};
    return image;
}

Image::Image(const Device& device, const ImageDesc& desc, vk::ImageUsageFlags usage)
    : Image(unbound(device, desc, usage)) {
    const vk::MemoryRequirements needs = requirements();
    memory_ = device.allocate(
        {needs.size, device.memory_type(needs.memoryTypeBits, MemoryBits::eDeviceLocal)});
    bind(memory_, 0);
}

void Image::bind(const vk::raii::DeviceMemory& memory, vk::DeviceSize offset) {
    image_.bindMemory(*memory, offset);
    make_views();
}

void Image::make_views() {
    const auto type = desc_.depth > 0    ? vk::ImageViewType::e3D
                      : desc_.layers > 0 ? vk::ImageViewType::e2DArray
                                         : vk::ImageViewType::e2D;
    const vk::Format format = vk_format(desc_.format);
    const vk::ImageSubresourceRange all(aspect_, 0, VK_REMAINING_MIP_LEVELS, 0,
                                        VK_REMAINING_ARRAY_LAYERS);
    constexpr auto viewed = vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eStorage |
                            vk::ImageUsageFlagBits::eColorAttachment |
                            vk::ImageUsageFlagBits::eDepthStencilAttachment;
    if (!(usage_ & viewed)) {
        return;
    }
    view_ = {device_->vk(), vk::ImageViewCreateInfo({}, *image_, type, format, {}, all)};
    constexpr auto attached =
        vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eDepthStencilAttachment;
    if (!(usage_ & attached)) {
        return;
    }
    for (std::uint32_t layer = 0; layer < desc_.layers; ++layer) {
        layer_views_.emplace_back(device_->vk(),
                                  vk::ImageViewCreateInfo({}, *image_, vk::ImageViewType::e2D,
                                                          format, {}, {aspect_, 0, 1, layer, 1}));
    }
}

Buffer Buffer::unbound(const Device& device, vk::DeviceSize bytes, vk::BufferUsageFlags usage) {
    Buffer buffer;
    buffer.bytes_ = bytes;
    buffer.serial_ = next_serial();
    buffer.buffer_ = {device.vk(), vk::BufferCreateInfo({}, bytes, usage)};
    return buffer;
}

void Buffer::bind(const vk::raii::DeviceMemory& memory, vk::DeviceSize offset) {
    buffer_.bindMemory(*memory, offset);
}

Buffer::Buffer(const Device& device, vk::DeviceSize bytes, vk::BufferUsageFlags usage,
               BufferMemory memory)
    : Buffer(unbound(device, bytes, usage)) {
    const vk::MemoryRequirements needs = requirements();
    constexpr auto host = MemoryBits::eHostVisible | MemoryBits::eHostCoherent;
    std::uint32_t type = 0;
    switch (memory) {
    case BufferMemory::device:
        type = device.memory_type(needs.memoryTypeBits, MemoryBits::eDeviceLocal);
        break;
    case BufferMemory::upload:
        type = device.memory_type(needs.memoryTypeBits, host);
        break;
    case BufferMemory::readback:
        type = device.memory_type(needs.memoryTypeBits, host, MemoryBits::eHostCached);
        break;
    }
    memory_ = device.allocate({needs.size, type});
    bind(memory_, 0);
    if (memory != BufferMemory::device) {
        mapped_ = {static_cast<std::byte*>(memory_.mapMemory(0, VK_WHOLE_SIZE)),
                   static_cast<std::size_t>(bytes)};
    }
}

Image make_image(const Device& device, const ImageDesc& desc, std::span<const std::byte> texels) {
    if (texels.size() != desc.bytes()) {
        throw std::logic_error("make_image: the texels do not fill the image");
    }
    Image image(device, desc,
                vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst |
                    vk::ImageUsageFlagBits::eTransferSrc);
    const Buffer staging(device, desc.bytes(), vk::BufferUsageFlagBits::eTransferSrc,
                         BufferMemory::upload);
    std::memcpy(staging.mapped().data(), texels.data(), texels.size());
    device.run_once([&](const vk::raii::CommandBuffer& commands) {
        move_layout(commands, image, vk::ImageLayout::eUndefined,
                    vk::ImageLayout::eTransferDstOptimal);
        commands.copyBufferToImage(staging.vk(), image.vk(), vk::ImageLayout::eTransferDstOptimal,
                                   whole(image));
        move_layout(commands, image, vk::ImageLayout::eTransferDstOptimal,
                    vk::ImageLayout::eReadOnlyOptimal);
    });
    return image;
}

Image make_target(const Device& device, const ImageDesc& desc) {
    Image image(device, desc, vk::ImageUsageFlagBits::eStorage);
    device.run_once([&](const vk::raii::CommandBuffer& commands) {
        move_layout(commands, image, vk::ImageLayout::eUndefined, vk::ImageLayout::eGeneral);
    });
    return image;
}

Buffer make_buffer(const Device& device, std::span<const std::byte> bytes) {
    using Usage = vk::BufferUsageFlagBits;
    Buffer buffer(device, bytes.size(),
                  Usage::eStorageBuffer | Usage::eUniformBuffer | Usage::eIndexBuffer |
                      Usage::eTransferDst,
                  BufferMemory::device);
    const Buffer staging(device, bytes.size(), Usage::eTransferSrc, BufferMemory::upload);
    std::memcpy(staging.mapped().data(), bytes.data(), bytes.size());
    device.run_once([&](const vk::raii::CommandBuffer& commands) {
        commands.copyBuffer(staging.vk(), buffer.vk(), vk::BufferCopy(0, 0, bytes.size()));
        record(commands, memory_barrier(transfer_write, everything));
    });
    return buffer;
}

std::vector<std::byte> read_image(const Device& device, const Image& image,
                                  vk::ImageLayout layout) {
    const Buffer staging(device, image.desc().bytes(), vk::BufferUsageFlagBits::eTransferDst,
                         BufferMemory::readback);
    device.run_once([&](const vk::raii::CommandBuffer& commands) {
        move_layout(commands, image, layout, vk::ImageLayout::eTransferSrcOptimal);
        commands.copyImageToBuffer(image.vk(), vk::ImageLayout::eTransferSrcOptimal, staging.vk(),
                                   whole(image));
        if (layout != vk::ImageLayout::eTransferSrcOptimal) {
            move_layout(commands, image, vk::ImageLayout::eTransferSrcOptimal, layout);
        }
        record(commands, memory_barrier(transfer_write, host_read));
    });
    return {staging.mapped().begin(), staging.mapped().end()};
}

} // namespace preview::gpu
