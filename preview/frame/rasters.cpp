#include "preview/frame/rasters.h"

#include "lutlib/error.h"
#include "preview/gpu/device.h"
#include "preview/passes/visibility.h"

namespace preview {

namespace {

/// Why compute shaders cannot rasterise there; empty when they can.
std::string_view missing(const gpu::Device& device, Size size) {
    if (!device.has_int64_atomics()) {
        return "the device has no 64-bit atomics on buffers";
    }
    if (visibility_bytes(size) > device.limits().maxStorageBufferRange) {
        return "the picture is too large for the device's storage buffers";
    }
    return {};
}

/// Integrated GPUs live on bandwidth, of which the visibility buffer takes more; CPUs have no
/// rasteriser that compute could beat.
Raster automatic(const gpu::Device& device, Size size) {
    const bool discrete =
        device.physical().getProperties().deviceType == vk::PhysicalDeviceType::eDiscreteGpu;
    return discrete && missing(device, size).empty() ? Raster::compute : Raster::hardware;
}

Raster compute(const gpu::Device& device, Size size) {
    if (const std::string_view why = missing(device, size); !why.empty()) {
        throw lutlib::UsageError("--raster compute is not possible: " + std::string(why) +
                                 "; choose hardware or auto");
    }
    return Raster::compute;
}

constexpr RasterChoice rows[] = {
    {"auto", "compute on discrete GPUs with 64-bit atomics, else hardware", automatic},
    {"hardware", "the GPU's rasteriser", [](const gpu::Device&, Size) { return Raster::hardware; }},
    {"compute", "compute shaders and a visibility buffer", compute},
    {"forward", "the GPU's rasteriser, which lights what it draws: no g-buffer, no occlusion",
     [](const gpu::Device&, Size) { return Raster::forward; }},
};

} // namespace

std::span<const RasterChoice> rasters() {
    return rows;
}

} // namespace preview
