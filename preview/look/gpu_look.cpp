#include "preview/look/gpu_look.h"

namespace preview {

namespace {

std::optional<gpu::Image> upload(const gpu::Device& device, const Texels& texels) {
    if (texels.bytes.empty()) {
        return std::nullopt;
    }
    return gpu::make_image(device, texels.desc, texels.bytes);
}

} // namespace

GpuLook::GpuLook(const gpu::Device& device, const LookData& data)
    : lookup(data.lookup), block(data.block), picture(upload(device, data.picture)),
      volume(upload(device, data.volume)), shaper(upload(device, data.shaper)),
      half_arithmetic(device.has_fast_half() &&
                      data.lookup->interpolation == lutlib::Interpolation::tetrahedral),
      groups(device.compute_units()) {
    if (!data.nodes.empty()) {
        nodes = gpu::make_buffer(device, std::as_bytes(std::span(data.nodes)));
    }
    stand(data);
}

void GpuLook::stand(const LookData& data) {
    place = data.conversion ? place_bits(*data.conversion) : 0;
    conversions =
        place != 0 ? conversion_rows(*data.conversion) : std::vector<std::array<float, 4>>();
}

} // namespace preview
