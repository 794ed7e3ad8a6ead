// A scene's or a picture's part on the GPU that stays while it is shown.
#pragma once

#include "preview/gpu/memory.h"
#include "preview/gpu/size.h"
#include "preview/scene/scene_data.h"

#include <span>

namespace preview {

/// Vertices and indices of a scene's meshes.
struct GpuScene {
    GpuScene(const gpu::Device& device, const Scene& scene);

    Geometry geometry;
    gpu::Buffer vertices, indices;
};

/// A picture as the scene. Linear light, or display-encoded as from a PNG.
struct GpuPicture {
    /// `rgba` has four floats a pixel, rows from the top.
    GpuPicture(const gpu::Device& device, Size size, std::span<const float> rgba,
               bool is_display_encoded);

    gpu::Image image;
    bool display_encoded = false;
};

} // namespace preview
