// A scene's or a picture's part on the GPU that stays while it is shown.
#pragma once

#include "preview/gpu/memory.h"
#include "preview/gpu/size.h"
#include "preview/scene/scene_data.h"

#include <optional>
#include <span>

namespace preview {

/// What surfaces have besides their materials' numbers.
struct GpuDetail {
    gpu::Buffer vertices, textures, texels;
    std::uint32_t halvings = 0; ///< largest levels of the textures that the device has no room for
    bool has_cutouts = false;
};

/// Vertices and indices of a scene's meshes.
struct GpuScene {
    GpuScene(const gpu::Device& device, const Scene& scene);

    Geometry geometry;
    gpu::Buffer vertices, indices;
    std::optional<GpuDetail> detail; ///< nothing for a scene without
};

/// The scene as a graph's passes read it; without lights and surroundings.
SceneHandles import_scene(Graph& graph, const Scene& scene, const GpuScene& gpu_scene,
                          const ViewBlock& view);

/// The scene's own surroundings, as lit surfaces take them.
void add_environment(Graph& graph, SceneHandles& handles, const Environment& environment);

/// A picture as the scene. Linear light, or display-encoded as from a PNG.
struct GpuPicture {
    /// `rgba` has four floats a pixel, rows from the top.
    GpuPicture(const gpu::Device& device, Size size, std::span<const float> rgba,
               bool is_display_encoded);

    gpu::Image image;
    bool display_encoded = false;
};

} // namespace preview
