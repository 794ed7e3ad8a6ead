#include "preview/finish/zoom.h"

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

/// Within the range, and whole where it comes near that: pixels are then told apart best.
float held(float scale) {
    const float within = std::clamp(scale, least_zoom, most_zoom);
    const float whole = std::round(within);
    return whole >= 1 && std::abs(within / whole - 1) < 0.02F ? whole : within;
}

/// Of one axis: where the picture begins, `length` long in an output of `room`.
std::int32_t begin_of(float middle, double length, double room) {
    const double begin =
        length <= room
            ? (room - length) / 2
            : std::clamp(room / 2 - static_cast<double>(middle) * length, room - length, 0.0);
    return static_cast<std::int32_t>(std::lround(begin));
}

/// The middle that puts the picture's begin there.
float middle_for(double begin, double length, double room) {
    const double least = std::min(room / 2 / length, 0.5);
    return static_cast<float>(std::clamp((room / 2 - begin) / length, least, 1 - least));
}

/// The zoom at that scale whose picture begins at these places, as near as it may.
Zoom at_places(Zoom zoom, float scale, double left, double top, Size own, Size output) {
    zoom.scale = scale;
    zoom.x = middle_for(left, static_cast<double>(scale) * own.width, output.width);
    zoom.y = middle_for(top, static_cast<double>(scale) * own.height, output.height);
    return zoom;
}

} // namespace

Size made_size(const Zoom& zoom, Size own) {
    if (zoom.scale >= 1) {
        return own;
    }
    const auto side = [&](std::uint32_t length) {
        return std::max(static_cast<std::uint32_t>(std::lround(static_cast<double>(length) *
                                                               static_cast<double>(zoom.scale))),
                        1U);
    };
    return {side(own.width), side(own.height)};
}

ZoomPlace zoom_place(const Zoom& zoom, Size own, Size made, Size output) {
    const double scale = static_cast<double>(zoom.scale) * own.width / std::max(made.width, 1U);
    // What was made smaller is not enlarged again by what its sides were rounded to.
    const double shown =
        zoom.scale < 1 && std::abs(scale - 1) < 0.5 / made.width + 1e-6 ? 1 : scale;
    return {begin_of(zoom.x, shown * made.width, output.width),
            begin_of(zoom.y, shown * made.height, output.height), static_cast<float>(shown)};
}

float fitting_scale(Size own, Size output) {
    return std::min(static_cast<float>(output.width) / static_cast<float>(own.width),
                    static_cast<float>(output.height) / static_cast<float>(own.height));
}

Zoom zoomed_by(const Zoom& zoom, float factor, OutputPoint fixed, Size own, Size output) {
    const float fit = fitting_scale(own, output);
    Zoom from = zoom;
    from.scale = zoom.scale > 0 ? zoom.scale : fit;
    const float scale = held(from.scale * factor);
    Zoom out = zoom;
    if (scale <= fit && factor < 1) {
        out.scale = 0;
        out.x = out.y = 0.5F;
        return out;
    }
    const ZoomPlace place = zoom_place(from, own, own, output);
    const double ratio = static_cast<double>(scale) / static_cast<double>(from.scale);
    const auto begin = [&](float at, std::int32_t before) {
        return static_cast<double>(at) - (static_cast<double>(at) - before) * ratio;
    };
    return at_places(out, scale, begin(fixed.x, place.left), begin(fixed.y, place.top), own,
                     output);
}

Zoom panned_by(const Zoom& zoom, OutputPoint by, Size own, Size output) {
    const double length_x = static_cast<double>(zoom.scale) * own.width,
                 length_y = static_cast<double>(zoom.scale) * own.height;
    return at_places(
        zoom, zoom.scale,
        output.width / 2.0 - static_cast<double>(zoom.x) * length_x + static_cast<double>(by.x),
        output.height / 2.0 - static_cast<double>(zoom.y) * length_y + static_cast<double>(by.y),
        own, output);
}

} // namespace preview
