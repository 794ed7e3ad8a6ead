#include "preview/passes/resolve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace preview {

namespace {

struct ResolvePush {
    std::array<std::int32_t, 2> corner, extent;
    float exposure;
};

} // namespace

Size fitted(Size picture, Size box) {
    const double scale = std::min(static_cast<double>(box.width) / picture.width,
                                  static_cast<double>(box.height) / picture.height);
    const auto side = [&](std::uint32_t length, std::uint32_t most) {
        return std::clamp(static_cast<std::uint32_t>(std::lround(length * scale)), 1U, most);
    };
    return {side(picture.width, box.width), side(picture.height, box.height)};
}

Resolved add_resolve(Graph& graph, ImageHandle source, Size size, float exposure, Format format,
                     bool is_kept) {
    constexpr std::string_view still_right = "scene, lights, camera and exposure are the same";
    const BufferHandle zero =
        graph.fill("clear maximum",
                   buffer_kept_if(graph, is_kept, "hdr maximum", sizeof(float), still_right), 0);
    Pass pass = graph.compute("hdr resolve", "resolve.comp");
    const Size extent = fitted(size_of(graph, source), size);
    pass.constants({size_of(graph, source) == size ? 0U : 1U, format == Format::rgba16f ? 1U : 0U});
    pass.read(source);
    Resolved out;
    out.hdr = pass.write(
        image_kept_if(graph, is_kept, "hdr", {format, size.width, size.height}, still_right));
    out.maximum = pass.modify(zero);
    const auto signed_pair = [](std::uint32_t x, std::uint32_t y) {
        return std::array{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    };
    pass.push(
        ResolvePush{signed_pair((size.width - extent.width) / 2, (size.height - extent.height) / 2),
                    signed_pair(extent.width, extent.height), exposure});
    pass.dispatch_over(size.width, size.height, many_each);
    return out;
}

} // namespace preview
