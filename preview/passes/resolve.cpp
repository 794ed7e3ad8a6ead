#include "preview/passes/resolve.h"

#include <algorithm>
#include <array>
#include <string>

namespace preview {

namespace {

struct ResolvePush {
    std::array<std::int32_t, 2> corner, extent;
    float exposure;
};

/// Declares shaders/resolve.comp from `source` into `target`, where the picture gets `extent` in
/// the middle. `maximum` is empty where nobody wants to know it. Returns both as they are then.
Resolved declare(Graph& graph, std::string_view name, ImageHandle source, Resolved target,
                 Size extent, float exposure) {
    Pass pass = graph.compute(name, "resolve.comp");
    const Size size = size_of(graph, target.hdr);
    const bool is_half = graph.image_desc(target.hdr).format == Format::rgba16f;
    pass.constants({size_of(graph, source) != size, is_half, static_cast<bool>(target.maximum)});
    pass.read(source);
    target.hdr = pass.write(target.hdr);
    if (target.maximum) {
        target.maximum = pass.modify(target.maximum);
    } else {
        static_cast<void>(pass.write(graph.buffer("no maximum", sizeof(float))));
    }
    const auto signed_pair = [](std::uint32_t x, std::uint32_t y) {
        return std::array{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    };
    pass.push(
        ResolvePush{signed_pair((size.width - extent.width) / 2, (size.height - extent.height) / 2),
                    signed_pair(extent.width, extent.height), exposure});
    pass.dispatch_over(size.width, size.height, many_each);
    return target;
}

/// Texels of the source that one of the picture covers, with those that it shares.
std::uint64_t covered(Size source, Size extent) {
    const auto along = [](std::uint32_t from, std::uint32_t to) {
        return std::uint64_t{from} / to + 2;
    };
    return along(source.width, extent.width) * along(source.height, extent.height);
}

} // namespace

Resolved add_resolve(Graph& graph, ImageHandle source, Size size, float exposure,
                     const ResolveWork& work) {
    const std::string name(work.name);
    // Mesa's software devices end the loops of an invocation after 65535 turns in all.
    constexpr std::uint64_t most_turns = 32768;
    Size from = size_of(graph, source);
    const Size extent = fitted(from, size);
    if (covered(from, extent) > most_turns) {
        from.width = extent.width;
        Resolved rows;
        rows.hdr = graph.image(name + " rows", {Format::rgba32f, from.width, from.height});
        source = declare(graph, name + " resolve along rows", source, rows, from, exposure).hdr;
        exposure = 1;
    }
    Resolved out;
    if (work.measures) {
        out.maximum = graph.fill(
            "clear maximum",
            buffer_kept_if(graph, work.is_kept, name + " maximum", sizeof(float), work.still_right),
            0);
    }
    out.hdr = image_kept_if(graph, work.is_kept, name, {work.format, size.width, size.height},
                            work.still_right);
    return declare(graph, name + " resolve", source, out, extent, exposure);
}

} // namespace preview
