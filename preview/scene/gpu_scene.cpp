#include "preview/scene/gpu_scene.h"

#include "preview/graph/graph.h"
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

template <class T>
BufferHandle data_or_nothing(Graph& graph, std::string_view name, const std::vector<T>& blocks) {
    return blocks.empty() ? BufferHandle{} : graph.data(name, std::as_bytes(std::span(blocks)));
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

void add_environment(Graph& graph, SceneHandles& handles, const Environment& environment) {
    handles.environment = graph.data_of("environment", environment_block(environment));
    handles.soft_boxes = static_cast<std::uint32_t>(environment.soft_box_count);
}

SceneHandles import_scene(Graph& graph, const Scene& scene, const GpuScene& gpu_scene,
                          const ViewBlock& view) {
    SceneHandles out;
    out.vertices = graph.import("vertices", gpu_scene.vertices, gpu_scene.vertices.bytes());
    out.indices = graph.import("indices", gpu_scene.indices, gpu_scene.indices.bytes());
    out.objects = data_or_nothing(graph, "objects", object_blocks(scene));
    out.materials = data_or_nothing(graph, "materials", material_blocks(scene));
    out.view = graph.data_of("view", view);
    out.has_own_light = scene.has_own_light();
    if (gpu_scene.detail) {
        const GpuDetail& detail = *gpu_scene.detail;
        out.detail.vertices =
            graph.import("vertex details", detail.vertices, detail.vertices.bytes());
        out.detail.materials =
            data_or_nothing(graph, "material details", material_detail_blocks(scene));
        out.detail.textures = graph.import("textures", detail.textures, detail.textures.bytes());
        out.detail.texels = graph.import("texels", detail.texels, detail.texels.bytes());
        out.detail.has_cutouts = detail.has_cutouts;
    }
    return out;
}

GpuPicture::GpuPicture(const gpu::Device& device, Size size, std::span<const float> rgba,
                       bool is_display_encoded)
    : image(
          gpu::make_image(device, {Format::rgba32f, size.width, size.height}, std::as_bytes(rgba))),
      display_encoded(is_display_encoded) {}

} // namespace preview
