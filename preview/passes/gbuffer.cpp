#include "preview/passes/gbuffer.h"

namespace preview {

void read_detail(Pass& pass, const SceneHandles& scene) {
    pass.storage(scene.detail.vertices);
    pass.storage(scene.materials);
    pass.storage(scene.detail.materials);
    pass.storage(scene.detail.textures);
    pass.storage(scene.detail.texels);
}

ImageHandle depth_image(Graph& graph, Format format, Size size, bool is_kept) {
    return image_kept_if(graph, is_kept, "depth", {format, size.width, size.height},
                         "neither the camera nor a thing has moved");
}

GBuffer add_gbuffer(Graph& graph, const SceneHandles& scene, Size size, std::vector<Draw> draws,
                    bool filters_normals, bool keeps_depth) {
    const auto target = [&](std::string_view name, Format format) {
        return graph.image(name, {format, size.width, size.height});
    };
    const bool has_detail = static_cast<bool>(scene.detail);
    Pass pass = has_detail ? graph.raster("g-buffer", "gbuffer_detail.vert", "gbuffer_detail.frag")
                           : graph.raster("g-buffer", "gbuffer.vert", "gbuffer.frag");
    pass.constants({filters_normals ? 1U : 0U});
    pass.storage(scene.vertices);
    pass.storage(scene.objects);
    pass.uniform(scene.view);
    if (has_detail) {
        read_detail(pass, scene);
    }
    pass.index_buffer(scene.indices);
    pass.draws(std::move(draws));
    GBuffer out;
    out.normal = pass.color(target("normal", Format::rg16ui), {});
    out.material = pass.color(target("material", Format::r32ui), {});
    if (has_detail) {
        out.albedo = pass.color(target("albedo", Format::rgba16f), {});
        out.emission = pass.color(target("emission", Format::rgba16f), {});
    }
    out.depth = pass.depth(depth_image(graph, Format::d32, size, keeps_depth), 1);
    return out;
}

} // namespace preview
