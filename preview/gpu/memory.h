// Images and buffers with their memory: move-only, freed with the object.
#pragma once

#include "preview/gpu/device.h"
#include "preview/gpu/types.h"

#include <span>
#include <vector>

namespace preview::gpu {

vk::Format vk_format(Format format);

/// An image with one mip level and its views.
class Image {
  public:
    /// With memory of its own.
    Image(const Device& device, const ImageDesc& desc, vk::ImageUsageFlags usage);
    /// Without memory: bind() comes before any use.
    static Image unbound(const Device& device, const ImageDesc& desc, vk::ImageUsageFlags usage);
    vk::MemoryRequirements requirements() const { return image_.getMemoryRequirements(); }
    void bind(const vk::raii::DeviceMemory& memory, vk::DeviceSize offset);

    const ImageDesc& desc() const { return desc_; }
    vk::Image vk() const { return *image_; }
    vk::ImageAspectFlags aspect() const { return aspect_; }
    /// Of the whole image, for shaders.
    vk::ImageView view() const { return *view_; }
    /// Of one layer, for attachments.
    vk::ImageView layer_view(std::uint32_t layer) const {
        return layer_views_.empty() ? *view_ : *layer_views_[layer];
    }
    /// Tells this image from any other that was ever made.
    std::uint64_t serial() const { return serial_; }

  private:
    Image() = default;
    void make_views();

    const Device* device_ = nullptr;
    ImageDesc desc_;
    vk::ImageAspectFlags aspect_;
    vk::ImageUsageFlags usage_;
    vk::raii::DeviceMemory memory_ = nullptr;
    vk::raii::Image image_ = nullptr;
    vk::raii::ImageView view_ = nullptr;
    std::vector<vk::raii::ImageView> layer_views_;
    std::uint64_t serial_ = 0;
};

enum class BufferMemory {
    device,   ///< fastest for the GPU
    upload,   ///< written by the host
    readback, ///< read by the host, cached
};

class Buffer {
  public:
    Buffer(const Device& device, vk::DeviceSize bytes, vk::BufferUsageFlags usage,
           BufferMemory memory);
    static Buffer unbound(const Device& device, vk::DeviceSize bytes, vk::BufferUsageFlags usage);
    vk::MemoryRequirements requirements() const { return buffer_.getMemoryRequirements(); }
    void bind(const vk::raii::DeviceMemory& memory, vk::DeviceSize offset);

    vk::Buffer vk() const { return *buffer_; }
    vk::DeviceSize bytes() const { return bytes_; }
    /// The host's view of it; empty for device memory.
    std::span<std::byte> mapped() const { return mapped_; }
    std::uint64_t serial() const { return serial_; }

  private:
    Buffer() = default;

    vk::DeviceSize bytes_ = 0;
    vk::raii::DeviceMemory memory_ = nullptr;
    vk::raii::Buffer buffer_ = nullptr;
    std::span<std::byte> mapped_;
    std::uint64_t serial_ = 0;
};

/// All texels of an image, tightly packed in a buffer from its beginning on.
vk::BufferImageCopy whole(const Image& image);

/// Moves an image to another layout: after all that came before, ahead of all that comes later.
void move_layout(const vk::raii::CommandBuffer& commands, const Image& image, vk::ImageLayout from,
                 vk::ImageLayout to);

/// A sampled image with these texels, rows from the top, tightly packed in its format.
Image make_image(const Device& device, const ImageDesc& desc, std::span<const std::byte> texels);

/// An image that shaders may write, ready for that, without contents.
Image make_target(const Device& device, const ImageDesc& desc);

/// A storage, uniform and index buffer with these contents.
Buffer make_buffer(const Device& device, std::span<const std::byte> bytes);

/// The texels of an image that stands in `layout` (and stays there). Waits for the GPU.
std::vector<std::byte> read_image(const Device& device, const Image& image, vk::ImageLayout layout);

} // namespace preview::gpu
