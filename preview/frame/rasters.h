// Who finds the visible triangles, the GPU's rasteriser or compute shaders, and whether they are
// lit once they are found or as they are drawn.
#pragma once

#include "preview/gpu/size.h"

#include <span>
#include <string_view>

namespace preview {

namespace gpu {
class Device;
}

enum class Raster { hardware, compute, forward };

struct RasterChoice {
    std::string_view name;
    std::string_view label;
    /// For a picture of that size. Throws lutlib::UsageError when the device cannot do it.
    Raster (*on)(const gpu::Device& device, Size size);
};

/// The first row decides by itself.
std::span<const RasterChoice> rasters();

} // namespace preview
