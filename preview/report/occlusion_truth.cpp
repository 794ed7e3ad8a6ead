#include "preview/report/occlusion_truth.h"

#include "preview/graph/interpose.h"
#include "preview/passes/copy.h"
#include "preview/reference/occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace preview::report {

namespace {

constexpr std::size_t many_pixels = 100'000;
constexpr int most_directions = 1024, directions_of_many = 256;

template <class T>
std::vector<T> values_of(const std::vector<std::byte>& bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

reference::Image image_of(const std::vector<double>& values, Size size) {
    reference::Image out(static_cast<int>(size.width), static_cast<int>(size.height));
    for (std::size_t i = 0; i < values.size(); ++i) {
        out.pixels[i] = {values[i], values[i], values[i]};
    }
    return out;
}

} // namespace

Truth occlusion_truth(const TruthRequest& request) {
    const Situation& base = request.base;
    Renderer& renderer = request.tools.renderer;
    Executor& executor = renderer.executor();
    FrameSettings settings = base.settings;
    settings.forced_keeps_maps = true;
    Graph graph;
    const FrameHandles handles = build_frame(graph, renderer.inputs_of(base), settings);
    Graph surfaces = graph;
    surfaces.present(handles.surfaces.depth);
    surfaces.present(handles.surfaces.normal);
    executor.render(surfaces);

    const Size size = base.settings.output;
    reference::SeenSurfaces seen;
    seen.view = view_block(base.settings.orbit,
                           static_cast<float>(size.width) / static_cast<float>(size.height));
    seen.width = static_cast<int>(size.width);
    seen.height = static_cast<int>(size.height);
    seen.depth = values_of<float>(executor.read_image(handles.surfaces.depth));
    for (const auto& bits :
         values_of<std::array<std::uint16_t, 2>>(executor.read_image(handles.surfaces.normal))) {
        seen.normal.push_back(reference::octahedral_normal(bits[0], bits[1]));
    }
    reference::OcclusionModel model;
    const OcclusionSettings& asked = base.settings.occlusion;
    model.strength =
        std::clamp(static_cast<double>(asked.strength * base.shown->scene->occlusion), 0.0, 2.0);
    model.radius = static_cast<double>(asked.radius);
    model.samples = seen.depth.size() > many_pixels ? directions_of_many : most_directions;
    const std::vector<double> left = reference::occlusion_of_every_pixel(seen, model);

    const std::vector<float> floats(left.begin(), left.end());
    const gpu::Image exact =
        gpu::make_image(renderer.device(), {Format::r32f, size.width, size.height},
                        std::as_bytes(std::span(floats)));
    const Graph lit =
        interposed(graph, handles.occlusion, [&](Graph& to, ImageHandle) -> ImageHandle {
            return add_copy(to, to.import("exact occlusion", exact, exact.desc()), Format::r32f);
        });
    executor.render(lit);
    Truth out;
    out.result = image_of(left, size);
    const auto codes = values_of<float>(executor.read_image(handles.output));
    out.finished = reference::Image(seen.width, seen.height);
    for (std::size_t i = 0; i < out.finished.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.finished.pixels[i][c] = static_cast<double>(codes[4 * i + c]);
        }
    }
    return out;
}

} // namespace preview::report
