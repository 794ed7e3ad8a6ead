#include "preview/scene/gpu_scene.h"

#include "preview/scene/texture_data.h"

#include <algorithm>

namespace preview {

namespace {

GpuDetail make_detail(const gpu::Device& device, const Scene& scene, const Geometry& geometry) {
    TextureData data = texture_data(scene, device.limits().maxStorageBufferRange);
    if (data.table.empty()) { // colours of vertices alone
        data.table.resize(1);
        data.texels.resize(1);
    }
    return {
        gpu::make_buffer(device, std::as_bytes(std::span(geometry.details))),
        gpu::make_buffer(device, std::as_bytes(std::span(data.table))),
        gpu::make_buffer(device, std::as_bytes(std::span(data.texels))), data.halvings,
        std::any_of(scene.materials.begin(), scene.materials.end(),
                    [](const Material& material) { return material.detail.least_coverage > 0; })};
}

} // namespace

GpuScene::GpuScene(const gpu::Device& device, const Scene& scene)
    : geometry(geometry_of(scene)),
      vertices(gpu::make_buffer(device, std::as_bytes(std::span(geometry.vertices)))),
      indices(gpu::make_buffer(device, std::as_bytes(std::span(geometry.indices)))) {
    if (!geometry.details.empty()) {
        detail = make_detail(device, scene, geometry);
    }
}

GpuPicture::GpuPicture(const gpu::Device& device, Size size, std::span<const float> rgba,
                       bool is_display_encoded)
    : image(
          gpu::make_image(device, {Format::rgba32f, size.width, size.height}, std::as_bytes(rgba))),
      display_encoded(is_display_encoded) {}

} // namespace preview
