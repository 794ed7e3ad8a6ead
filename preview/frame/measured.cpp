#include "preview/frame/measured.h"

#include "lutlib/half.h"
#include "preview/finish/blooms.h"
#include "preview/finish/metering.h"
#include "preview/frame/frame.h"
#include "preview/frame/frame_effects.h"
#include "preview/frame/frame_zoom.h"

#include <algorithm>
#include <cmath>
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

namespace {

/// The light of a frame before bloom and effects, at any exposure.
class Meter {
  public:
    Meter(Executor& executor, const FrameInputs& inputs, const FrameSettings& settings,
          const std::optional<ProbePlace>& place)
        : executor_(executor), inputs_(inputs), settings_(settings) {
        settings_.view = nullptr;
        settings_.effect_view = nullptr;
        settings_.probe = place;
        settings_.zoom = place ? settings.zoom : Zoom{}; // the mean is of all of it
        settings_.only_maximum = settings_.keep_hdr = true;
    }

    std::vector<std::uint16_t> halves(double exposure) {
        settings_.exposure = static_cast<float>(exposure);
        Graph graph;
        const FrameHandles handles = build_frame(graph, inputs_, settings_);
        executor_.render(graph);
        const std::vector<std::byte> bytes = executor_.read_image(handles.hdr);
        std::vector<std::uint16_t> out(bytes.size() / sizeof(std::uint16_t));
        std::memcpy(out.data(), bytes.data(), bytes.size());
        const ImageDesc& desc = graph.image_desc(handles.hdr);
        size_ = {desc.width, desc.height};
        return out;
    }

    lutlib::RgbD at_place(double exposure) {
        const std::vector<std::uint16_t> rgba = halves(exposure);
        const ProbePlace place = probe_place(inputs_, settings_, size_).value();
        const auto within = [](std::int32_t at, std::uint32_t length) { // side by side: of both
            return static_cast<std::size_t>(std::max(at, 0)) % length;
        };
        const std::size_t first =
            4 * (within(place.y, size_.height) * size_.width + within(place.x, size_.width));
        const auto channel = [&](std::size_t c) {
            return static_cast<double>(lutlib::float_from_half(rgba.at(first + c)));
        };
        return {channel(0), channel(1), channel(2)};
    }

  private:
    Executor& executor_;
    const FrameInputs& inputs_;
    FrameSettings settings_;
    Size size_;
};

/// Of a place, the same whatever the exposure is now. Light is kept in half floats, exposed: it is
/// looked at twice, the second time near grey, where they have all their digits.
std::optional<double> stops_at_place(Meter& meter, double least, double most) {
    constexpr double largest_half = 65504;
    double exposure = 0;
    lutlib::RgbD light = meter.at_place(exposure);
    if (std::max({light.r, light.g, light.b}) >= largest_half) {
        light = meter.at_place(exposure = least);
    } else if (!stops_to_grey(light)) {
        light = meter.at_place(exposure = most);
    }
    const std::optional<double> first = stops_to_grey(light);
    if (!first) {
        return std::nullopt;
    }
    exposure = std::clamp(std::round(exposure + *first), least, most);
    const std::optional<double> second = stops_to_grey(meter.at_place(exposure));
    return second ? std::optional(exposure + *second) : std::nullopt;
}

} // namespace

std::optional<float> metered_exposure(Executor& executor, const FrameInputs& inputs,
                                      const FrameSettings& settings,
                                      std::optional<ProbePlace> place) {
    if (is_display_encoded(inputs)) {
        return std::nullopt;
    }
    const NumberRow<PictureSettings>& row = picture_number("exposure");
    const auto least = static_cast<double>(row.min), most = static_cast<double>(row.max);
    Meter meter(executor, inputs, settings, place);
    const std::optional<double> stops =
        place ? stops_at_place(meter, least, most) : stops_to_grey(meter.halves(0));
    return stops ? std::optional(static_cast<float>(std::clamp(*stops, least, most)))
                 : std::nullopt;
}

} // namespace preview
