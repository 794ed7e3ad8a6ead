#include "preview/editor/wheel.h"

#include "lutlib/color/luma.h"

#include <algorithm>
#include <cmath>

namespace preview::editor {

namespace {

using lutlib::RgbD;

// ITU-R BT.709: Cb = (B - Y) / 1.8556, Cr = (R - Y) / 1.5748.
constexpr double blue_share = 1.8556, red_share = 1.5748;

/// What colour differences add to codes, at the same luma.
RgbD from_differences(double cb, double cr) {
    const double r = red_share * cr, b = blue_share * cb;
    const RgbD weights{lutlib::luma({1, 0, 0}), lutlib::luma({0, 1, 0}), lutlib::luma({0, 0, 1})};
    return {r, -(weights.r * r + weights.b * b) / weights.g, b};
}

double sign_of(const lutlib::Parameter& parameter) {
    return parameter.wheel.is_inverted ? -1 : 1;
}

/// The largest share of `change` that keeps `from` + `change` within the range, `from` being in it.
double share_within(const lutlib::Parameter& parameter, double from, double change) {
    const double end = change > 0 ? parameter.max : parameter.min;
    return from + change > parameter.max || from + change < parameter.min ? (end - from) / change
                                                                          : 1;
}

} // namespace

WheelPlace wheel_place(const lutlib::Parameter& parameter, RgbD value) {
    const RgbD change = (value - parameter.fallback_rgb) * sign_of(parameter);
    const double y = lutlib::luma(change);
    return {(change.b - y) / blue_share / parameter.wheel.balance,
            (change.r - y) / red_share / parameter.wheel.balance, y / parameter.wheel.brightness};
}

RgbD value_on_wheel(const lutlib::Parameter& parameter, const WheelPlace& place) {
    const double sign = sign_of(parameter);
    const double y =
        std::clamp(parameter.fallback_rgb.r + sign * place.turn * parameter.wheel.brightness,
                   parameter.min, parameter.max);
    const RgbD change = from_differences(sign * place.x * parameter.wheel.balance,
                                         sign * place.y * parameter.wheel.balance);
    double share = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        share = std::min(share, share_within(parameter, y, change[i]));
    }
    RgbD out;
    for (std::size_t i = 0; i < 3; ++i) {
        out[i] = std::clamp(y + share * change[i], parameter.min, parameter.max);
    }
    return out;
}

RgbD wheel_color(double angle) {
    constexpr double chroma = 0.26; // within 0..1 in every direction
    return lutlib::saturate(RgbD{0.5, 0.5, 0.5} +
                            from_differences(chroma * std::cos(angle), chroma * std::sin(angle)));
}

} // namespace preview::editor
