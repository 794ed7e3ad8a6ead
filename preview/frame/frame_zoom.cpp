#include "preview/frame/frame_zoom.h"

#include "preview/passes/magnify.h"
#include "preview/passes/split_line.h"
#include "preview/scene/gpu_scene.h"

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

/// The size that a zoom is told of: the picture's own, and of a scene what it is rendered for.
Size own_size(const FrameInputs& inputs, const FrameSettings& settings) {
    if (inputs.picture == nullptr) {
        return picture_size(settings.output, *settings.compare);
    }
    const ImageDesc& desc = inputs.picture->image.desc();
    return {desc.width, desc.height};
}

/// A scene has no more pixels than it is rendered for, and no fewer.
Zoom zoom_of(const FrameInputs& inputs, const FrameSettings& settings) {
    Zoom out = settings.zoom;
    out.scale = inputs.picture == nullptr ? std::max(out.scale, 1.0F) : out.scale;
    return out;
}

ZoomPlace place_of(const FrameInputs& inputs, const FrameSettings& settings, Size finished) {
    return zoom_place(zoom_of(inputs, settings), own_size(inputs, settings), finished,
                      picture_size(settings.output, *settings.compare));
}

} // namespace

bool zooms(const FrameSettings& settings) {
    return settings.zoom.scale > 0 && settings.scope == nullptr && !settings.shows_intermediate();
}

Size finished_size(const FrameInputs& inputs, const FrameSettings& settings) {
    return zooms(settings) ? made_size(zoom_of(inputs, settings), own_size(inputs, settings))
                           : picture_size(settings.output, *settings.compare);
}

std::optional<ProbePlace> probe_place(const FrameInputs& inputs, const FrameSettings& settings,
                                      Size finished) {
    if (!settings.probe || !zooms(settings)) {
        return settings.probe;
    }
    const ZoomPlace place = place_of(inputs, settings, finished);
    const auto texel = [&](std::int32_t at, std::int32_t begin, std::uint32_t length) {
        const double inside =
            (static_cast<double>(at - begin) + 0.5) / static_cast<double>(place.scale);
        return static_cast<std::int32_t>(
            std::clamp(std::floor(inside), 0.0, static_cast<double>(length) - 1));
    };
    const Size output = picture_size(settings.output, *settings.compare);
    const std::int32_t x = settings.compare == &compare_side
                               ? settings.probe->x % static_cast<std::int32_t>(output.width)
                               : settings.probe->x;
    return ProbePlace{texel(x, place.left, finished.width),
                      texel(settings.probe->y, place.top, finished.height)};
}

WipeShape zoom_in(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                  bool is_viewed, FrameHandles& handles) {
    if (!zooms(settings)) {
        graph.withhold("magnify",
                       settings.zoom.scale > 0 ? "a scope is shown" : "all of the picture is seen");
        return wipe_shape(settings, *settings.compare, size_of(graph, handles.hdr));
    }
    const Size finished = size_of(graph, handles.hdr);
    Magnifying how{.place = place_of(inputs, settings, finished),
                   .magnifier = settings.zoom.magnifier,
                   .output = picture_size(settings.output, *settings.compare),
                   .is_pair = settings.compare == &compare_side};
    const WipeShape wipe = placed(wipe_shape(settings, *settings.compare, finished),
                                  *settings.compare, static_cast<float>(how.place.left),
                                  static_cast<float>(how.place.top), how.place.scale);
    if (is_viewed) {
        handles.unrounded = add_magnify(graph, handles.unrounded, how);
        if (handles.before_looks) {
            handles.before_looks = add_magnify(graph, handles.before_looks, how);
        }
        return wipe;
    }
    if (settings.compare == &compare_difference) {
        how.heat_scale = settings.heat_scale < 0 ? usual_heat_scale : settings.heat_scale;
    }
    handles.output = add_magnify(graph, handles.output, how);
    if (settings.compare->shows_one) {
        handles.output = add_split_line(graph, handles.output, *settings.compare, wipe);
    }
    return wipe;
}

} // namespace preview
