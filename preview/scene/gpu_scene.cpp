#include "preview/scene/gpu_scene.h"

namespace preview {

GpuScene::GpuScene(const gpu::Device& device, const Scene& scene)
    : geometry(geometry_of(scene)),
      vertices(gpu::make_buffer(device, std::as_bytes(std::span(geometry.vertices)))),
      indices(gpu::make_buffer(device, std::as_bytes(std::span(geometry.indices)))) {}

GpuPicture::GpuPicture(const gpu::Device& device, Size size, std::span<const float> rgba,
                       bool is_display_encoded)
    : image(
          gpu::make_image(device, {Format::rgba32f, size.width, size.height}, std::as_bytes(rgba))),
      display_encoded(is_display_encoded) {}

} // namespace preview
