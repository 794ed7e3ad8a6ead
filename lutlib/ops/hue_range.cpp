// Hue-selective range: what three qualifiers choose, a band of hues, one of saturation and one of
// luminance, is turned, saturated and lit on its own.
//
// A hue counts fully within width / 2 of the centre, a saturation or luminance between its low and
// its high; outside, each falls to nothing over its softness, along a raised cosine. A low of 0 and
// a high of 1 have no outside: they choose what lies beyond 0..1 too. The three are multiplied.
#include "lutlib/ops/secondary.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace lutlib::op {
namespace {

constexpr Parameter number(std::string_view name, std::string_view flag, std::string_view label,
                           std::string_view unit, double min, double max, double fallback) {
    return {.name = name,
            .flag = flag,
            .label = label,
            .unit = unit,
            .min = min,
            .max = max,
            .fallback = fallback};
}

constexpr Parameter toggle(std::string_view name, std::string_view flag, std::string_view label) {
    return {.name = name, .flag = flag, .label = label, .kind = ParameterKind::toggle};
}

constexpr Parameter hue_range_parameters[] = {
    number("centre", "range-centre", "Centre", "degrees, red at 0", 0, 360, 0),
    number("width", "range-width", "Width", "degrees", 0, 360, 40),
    number("softness", "range-softness", "Softness", "degrees", 5, 180, 30),
    number("turn", "range-turn", "Turn", "degrees", -180, 180, 0),
    number("saturation", "range-saturation", "Saturation", "factor", 0, 4, 1),
    number("luminance", "range-luminance", "Luminance", "factor", 0, 2, 1),
    toggle("any_hue", "range-any-hue", "Any hue, and neutrals"),
    number("saturation_low", "range-saturation-low", "Saturation from", saturation_axis.unit, 0, 1,
           0),
    number("saturation_high", "range-saturation-high", "Saturation up to", saturation_axis.unit, 0,
           1, 1),
    number("saturation_softness", "range-saturation-softness", "Saturation's softness",
           saturation_axis.unit, 0.01, 1, 0.1),
    number("luminance_low", "range-luminance-low", "Luminance from", luminance_axis.unit, 0, 1, 0),
    number("luminance_high", "range-luminance-high", "Luminance up to", luminance_axis.unit, 0, 1,
           1),
    number("luminance_softness", "range-luminance-softness", "Luminance's softness",
           luminance_axis.unit, 0.01, 1, 0.1),
    toggle("matte", "range-matte", "Show what is chosen, as a matte"),
};

enum At : std::size_t {
    centre,
    width,
    softness,
    turn,
    saturation,
    luminance,
    any_hue,
    saturation_low,
    saturation_high,
    saturation_softness,
    luminance_low,
    luminance_high,
    luminance_softness,
    matte
};

double value_at(const Values& values, At place) {
    return std::get<double>(values[place]);
}

/// 1 at no distance outside of a range, 0 from the softness on.
double fall(double outside, double softness) {
    return 0.5 + 0.5 * std::cos(std::clamp(outside / softness, 0.0, 1.0) * std::numbers::pi);
}

/// A range of saturation or luminance.
struct Band {
    double low, high, softness;

    double weight(double x) const {
        const double below = low > 0 ? low - x : 0, above = high < 1 ? x - high : 0;
        return fall(std::max({below, above, 0.0}), softness);
    }
};

/// How much a colour of Oklab is chosen.
struct Qualifier {
    explicit Qualifier(const Values& values)
        : centre(value_at(values, At::centre)), full(value_at(values, At::width) / 2),
          softness(value_at(values, At::softness)),
          takes_any_hue(value_at(values, At::any_hue) != 0),
          saturation{value_at(values, At::saturation_low), value_at(values, At::saturation_high),
                     value_at(values, At::saturation_softness)},
          luminance{value_at(values, At::luminance_low), value_at(values, At::luminance_high),
                    value_at(values, At::luminance_softness)} {}

    double weight(RgbD c) const {
        return hue(c) * saturation.weight(saturation_of(c)) * luminance.weight(c.r);
    }
    /// Neutrals, which have no hue, have none of it.
    double weight_of_light(RgbD c) const { return weight(c) * (takes_any_hue ? 1 : hue_weight(c)); }

  private:
    double hue(RgbD c) const {
        const double away = std::abs(std::remainder(dial_hue(c.g, c.b) - centre, 360.0));
        return takes_any_hue ? 1 : fall(away - full, softness);
    }

    double centre, full, softness;
    bool takes_any_hue;
    Band saturation, luminance;
};

Transform compile_hue_range(const Values& values, const OpContext&) {
    const Qualifier chosen(values);
    if (value_at(values, At::matte) != 0) {
        return Transform::each([chosen](RgbD c) { return RgbD{chosen.weight_of_light(c), 0, 0}; });
    }
    const double turn = value_at(values, At::turn), saturation = value_at(values, At::saturation),
                 luminance = value_at(values, At::luminance);
    return Transform::each([=](RgbD c) {
        const double weight = chosen.weight(c);
        const RgbD out = with_chroma(rotated(c, turn * weight), 1 + (saturation - 1) * weight);
        return out * (1 + (luminance - 1) * chosen.weight_of_light(c));
    });
}

bool is_matte(const Values& values) {
    return value_at(values, At::matte) != 0;
}

std::string note(const Values& values, const OpContext&) {
    return is_matte(values) ? "--range-matte shows which colours the hue range takes, in place of "
                              "the look; turn it off for the look"
                            : "";
}

} // namespace

const Op hue_range{.name = "hue-range",
                   .label = "Hue range",
                   .help = "Turns, saturates and lights what qualifiers of hue, saturation and "
                           "luminance choose; they can be seen as a matte",
                   .reference = "rotation and factors in Oklab, weighted by the product of raised "
                                "cosines of hue, saturation and luminance; luminance and the matte "
                                "also fade towards neutrals, which have no hue",
                   .space = Space::oklab,
                   .parameters = hue_range_parameters,
                   .compile = compile_hue_range,
                   .note = note,
                   .is_matte = is_matte};

} // namespace lutlib::op
