#include "preview/frame/measured.h"

#include "lutlib/half.h"
#include "preview/finish/blooms.h"
#include "preview/finish/metering.h"
#include "preview/frame/frame.h"
#include "preview/frame/frame_effects.h"

#include <algorithm>
#include <cstring>

namespace preview {

std::optional<float> measured_maximum(Executor& executor, const FrameInputs& inputs,
                                      const FrameSettings& settings) {
    if (settings.shows_intermediate() || settings.force_all || settings.bloom == nullptr ||
        settings.without.has(Effect::bloom) || bloom_onset(settings.bloom_settings) <= 0 ||
        is_display_encoded(inputs)) {
        return inputs.hdr_maximum;
    }
    FrameSettings measuring = settings;
    measuring.only_maximum = true;
    Graph graph;
    const FrameHandles handles = build_frame(graph, inputs, measuring);
    executor.render(graph);
    float maximum = 0;
    std::memcpy(&maximum, executor.read_buffer(handles.hdr_maximum).data(), sizeof maximum);
    return maximum;
}

std::optional<float> metered_exposure(Executor& executor, const FrameInputs& inputs,
                                      const FrameSettings& settings,
                                      std::optional<ProbePlace> place) {
    if (is_display_encoded(inputs)) {
        return std::nullopt;
    }
    FrameSettings measuring = settings;
    measuring.view = nullptr;
    measuring.effect_view = nullptr;
    measuring.exposure = 0;
    measuring.zoom = {};
    measuring.only_maximum = measuring.keep_hdr = true;
    Graph graph;
    const FrameHandles handles = build_frame(graph, inputs, measuring);
    executor.render(graph);
    const std::vector<std::byte> bytes = executor.read_image(handles.hdr);
    std::vector<std::uint16_t> halves(bytes.size() / sizeof(std::uint16_t));
    std::memcpy(halves.data(), bytes.data(), bytes.size());
    std::optional<double> stops;
    if (place) {
        const std::uint32_t width = graph.image_desc(handles.hdr).width;
        const std::size_t first =
            4 * (static_cast<std::size_t>(place->y) * width + static_cast<std::size_t>(place->x));
        const auto channel = [&](std::size_t c) {
            return static_cast<double>(lutlib::float_from_half(halves.at(first + c)));
        };
        stops = stops_to_grey(lutlib::RgbD{channel(0), channel(1), channel(2)});
    } else {
        stops = stops_to_grey(halves);
    }
    if (!stops) {
        return std::nullopt;
    }
    const NumberRow<PictureSettings>& row = picture_number("exposure");
    return static_cast<float>(
        std::clamp(*stops, static_cast<double>(row.min), static_cast<double>(row.max)));
}

} // namespace preview
