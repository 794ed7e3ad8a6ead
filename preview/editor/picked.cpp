#include "preview/editor/picked.h"

#include "lutlib/color/luma.h"
#include "lutlib/color/oklab.h"
#include "lutlib/ops/white_balance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace preview::editor {

namespace {

using lutlib::Operation;
using lutlib::RgbD;

/// The codes that the look gets there.
RgbD codes_into_look(const State& state, const Probe& probe) {
    const LookStanding where = standing_of(encodings_of(state.recipe), nullptr, state.picture);
    if (!where.conversion) {
        return probe.before;
    }
    const lutlib::Encoding from =
        where.is_before() ? *lutlib::encoding_named("linear") : state.picture.encoding;
    return lutlib::conversion({from, where.conversion->fed})(where.is_before() ? probe.light
                                                                               : probe.before);
}

bool put_white(Operation& operation, RgbD light, const lutlib::OpContext& context) {
    const auto found = lutlib::op::white_balance_of(light, context.primaries);
    if (found) {
        operation.values = {std::round(found->kelvin), std::round(100 * found->tint) / 100};
    }
    return found.has_value();
}

bool put_hue(Operation& operation, RgbD lab, const lutlib::OpContext& /*context*/) {
    constexpr double least_chroma = 0.005; // of which a hue can be told
    if (!(std::hypot(lab.g, lab.b) > least_chroma)) {
        return false;
    }
    operation.values[0] = std::round(10 * lutlib::dial_hue(lab.g, lab.b)) / 10;
    return true;
}

constexpr std::array<Picker, 2> picker_rows{{
    {.op = "white-balance",
     .label = "Pick what is white or grey",
     .help = "Click on the picture where it should be neutral: temperature and tint follow",
     .put = &put_white},
    {.op = "hue-range",
     .label = "Pick the hue",
     .help = "Click on the picture: its hue becomes the centre of the range",
     .put = &put_hue},
}};

} // namespace

RgbD color_into(const State& state, const Probe& probe, std::size_t at) {
    const Operation& operation = state.recipe.operations[at];
    lutlib::Recipe before = state.recipe;
    before.operations.resize(at);
    before.output.reset();
    before.opacity = 1;
    const RgbD codes = lutlib::Transform::of(before)(codes_into_look(state, probe));
    if (operation.op->space == lutlib::Space::codes) {
        return codes;
    }
    const lutlib::Encoding& input = state.recipe.input;
    const RgbD light{input.decode(codes.r), input.decode(codes.g), input.decode(codes.b)};
    return operation.op->space == lutlib::Space::linear
               ? light
               : lutlib::oklab_from_lms(lutlib::oklab_cones(input.primaries()) * light);
}

double place_on_axis(const Operation& operation, std::size_t parameter, RgbD color) {
    const lutlib::Parameter& row = operation.op->parameters[parameter];
    const auto on_axis = [&] {
        if (row.axis.label == "hue") {
            return lutlib::dial_hue(color.g, color.b);
        }
        if (row.axis.label == "saturation") {
            return std::hypot(color.g, color.b) / lutlib::srgb_chroma;
        }
        if (row.axis.label == "luminance") {
            return color.r;
        }
        if (parameter == 0) {
            return lutlib::luma(color);
        }
        // A channel's curve gets what the master curve, the first, gives.
        Operation master = default_operation(*operation.op);
        master.values[0] = operation.values[0];
        return operation.op->compile(master.values, {})(color)[parameter - 1];
    };
    return std::clamp(on_axis(), row.axis.min, row.axis.max);
}

std::span<const Picker> pickers() {
    return picker_rows;
}

} // namespace preview::editor
