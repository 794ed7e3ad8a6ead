// Tone curves on code values: the master curve on every channel, then one for each channel.
//
// Outside its knots a curve goes on with slope 1, keeping the change that it has at its end, so
// that a neutral curve is the identity for HDR and negative values too.
#include "lutlib/ops/all.h"

#include <algorithm>
#include <array>
#include <optional>

namespace lutlib::op {
namespace {

constexpr Parameter tone(std::string_view name, std::string_view flag, std::string_view label) {
    return {
        .name = name,
        .flag = flag,
        .label = label,
        .unit = "code value",
        .kind = ParameterKind::curve,
        .min = -1,
        .max = 16,
        .axis = {.label = "input", .unit = "code value", .min = -1, .max = 16, .diagonal = true}};
}

constexpr Parameter curves_parameters[] = {
    tone("master", "curve", "Master"),
    tone("red", "curve-red", "Red"),
    tone("green", "curve-green", "Green"),
    tone("blue", "curve-blue", "Blue"),
};

class Tone {
  public:
    Tone(const Parameter& parameter, const Value& value) {
        if (!std::get<Knots>(value).empty()) {
            curve_ = curve_of(parameter, value);
            low_ = curve_->first_x();
            high_ = curve_->last_x();
        }
    }
    double operator()(double x) const {
        if (!curve_) {
            return x;
        }
        const double inside = std::clamp(x, low_, high_);
        return (*curve_)(inside) + (x - inside);
    }

  private:
    std::optional<Curve> curve_;
    double low_ = 0, high_ = 0;
};

Transform compile_curves(const Values& values, const OpContext&) {
    const std::array<Tone, 4> t{
        Tone{curves_parameters[0], values[0]}, Tone{curves_parameters[1], values[1]},
        Tone{curves_parameters[2], values[2]}, Tone{curves_parameters[3], values[3]}};
    return Transform::each([t](RgbD c) {
        return RgbD{t[1](t[0](c.r)), t[2](t[0](c.g)), t[3](t[0](c.b))};
    });
}

} // namespace

const Op curves{.name = "curves",
                .label = "Curves",
                .help = "Tone curves through knots, for all channels and for each",
                .reference = "Fritsch and Carlson 1980, see curve.h; slope 1 outside the knots",
                .space = Space::codes,
                .parameters = curves_parameters,
                .per_channel = always,
                .compile = compile_curves};

} // namespace lutlib::op
