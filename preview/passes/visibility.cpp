#include "preview/passes/visibility.h"

#include <algorithm>

namespace preview {

namespace {

constexpr std::uint32_t most_groups = 65535; ///< in one direction, on every device
constexpr std::uint64_t key_bytes = 8;
constexpr std::uint64_t large_triangle_bytes = 48; ///< LargeTriangle of common/raster.glsl

struct SharedPush {
    std::int32_t width = 0, height = 0;
};
struct TrianglesPush {
    SharedPush size;
    std::uint32_t cluster_count = 0, capacity = 0;
};
struct TilesPush {
    SharedPush size;
    std::uint32_t capacity = 0;
};

BufferHandle rasterise(Graph& graph, const SceneHandles& scene, SharedPush size, BufferHandle keys,
                       BufferHandle clusters, std::uint32_t cluster_count,
                       const VisibilityLimits& limits) {
    BufferHandle counts = graph.fill("no large triangles", graph.buffer("large counts", 8), 0);
    BufferHandle large =
        graph.buffer("large triangles", limits.large_triangles * large_triangle_bytes);
    const bool has_cutouts = scene.detail.has_cutouts;
    const auto read_cutouts = [&](Pass& pass) {
        if (has_cutouts) {
            pass.storage(scene.detail.vertices);
            pass.storage(scene.detail.materials);
            pass.storage(scene.detail.textures);
            pass.storage(scene.detail.texels);
        }
    };
    Pass triangles = graph.compute("triangles", has_cutouts ? "visibility_triangles_cutout.comp"
                                                            : "visibility_triangles.comp");
    triangles.constants({limits.small_side});
    triangles.storage(scene.vertices);
    triangles.storage(scene.indices);
    triangles.storage(scene.objects);
    triangles.storage(clusters);
    triangles.uniform(scene.view);
    keys = triangles.modify(keys);
    counts = triangles.modify(counts);
    large = triangles.write(large);
    read_cutouts(triangles);
    triangles.push(TrianglesPush{size, cluster_count, limits.large_triangles});
    const std::uint32_t columns = std::min(cluster_count, most_groups);
    triangles.dispatch(columns, (cluster_count + columns - 1) / columns);

    Pass tiles = graph.compute("large triangles", has_cutouts ? "visibility_tiles_cutout.comp"
                                                              : "visibility_tiles.comp");
    tiles.storage(counts);
    tiles.storage(large);
    keys = tiles.modify(keys);
    if (has_cutouts) {
        tiles.storage(scene.vertices);
        tiles.storage(scene.indices);
        tiles.storage(scene.objects);
        tiles.storage(clusters);
        tiles.uniform(scene.view);
        read_cutouts(tiles);
    }
    tiles.push(TilesPush{size, limits.large_triangles});
    tiles.dispatch(limits.tile_groups);
    return keys;
}

} // namespace

std::vector<ClusterBlock> cluster_blocks(const std::vector<Draw>& draws) {
    std::vector<ClusterBlock> blocks;
    for (const Draw& draw : draws) {
        for (std::uint32_t done = 0; done < draw.index_count / 3; done += ClusterBlock::triangles) {
            blocks.push_back({draw.first_index + 3 * done, draw.vertex_offset, draw.first_instance,
                              std::min(draw.index_count / 3 - done, ClusterBlock::triangles)});
        }
    }
    return blocks;
}

std::uint64_t visibility_bytes(Size size) {
    return std::uint64_t{(size.width + 7) / 8} * ((size.height + 7) / 8) * 64 * key_bytes;
}

GBuffer add_visibility(Graph& graph, const SceneHandles& scene, Size size,
                       const std::vector<Draw>& draws, const VisibilityLimits& limits,
                       bool filters_normals, bool keeps_depth) {
    const std::vector<ClusterBlock> blocks = cluster_blocks(draws);
    BufferHandle clusters;
    BufferHandle keys =
        graph.fill("no triangles", graph.buffer("visibility", visibility_bytes(size)), ~0U);
    if (!blocks.empty()) {
        clusters = graph.data("clusters", std::as_bytes(std::span(blocks)));
        keys = rasterise(
            graph, scene,
            {static_cast<std::int32_t>(size.width), static_cast<std::int32_t>(size.height)}, keys,
            clusters, static_cast<std::uint32_t>(blocks.size()), limits);
    }

    const auto target = [&](std::string_view name, Format format) {
        return graph.image(name, {format, size.width, size.height});
    };
    const bool has_detail = static_cast<bool>(scene.detail);
    Pass pass = graph.compute("g-buffer", has_detail ? "visibility_gbuffer_detail.comp"
                                                     : "visibility_gbuffer.comp");
    pass.constants({filters_normals ? 1U : 0U});
    pass.storage(scene.vertices);
    pass.storage(scene.indices);
    pass.storage(scene.objects);
    pass.storage(clusters);
    pass.uniform(scene.view);
    pass.storage(keys);
    GBuffer out;
    out.normal = pass.write_if_read(target("normal", Format::rg16ui));
    out.material = pass.write_if_read(target("material", Format::r32ui));
    out.depth = pass.write(depth_image(graph, Format::r32f, size, keeps_depth));
    if (has_detail) {
        out.albedo = pass.write_if_read(target("albedo", Format::rgba16f));
        out.emission = pass.write_if_read(target("emission", Format::rgba16f));
        read_detail(pass, scene);
    }
    pass.dispatch_over(size.width, size.height);
    return out;
}

} // namespace preview
