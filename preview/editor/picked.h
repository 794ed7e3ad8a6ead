// What a colour that was picked in the picture is to an operator.
#pragma once

#include "preview/editor/model.h"
#include "preview/finish/probe.h"

#include <optional>
#include <span>

namespace preview::editor {

/// The colour that the operator `at` gets where the picture has the probed one, in the operator's
/// space: through what is converted before the look, the base and the operators before it that are
/// on.
lutlib::RgbD color_into(const State& state, const Probe& probe, std::size_t at);

/// Where such a colour lies on the axis of a curve of the operator, within the axis. `parameter` is
/// one of its curves.
double place_on_axis(const lutlib::Operation& operation, std::size_t parameter, lutlib::RgbD color);

/// An operator whose values can be picked as one colour.
struct Picker {
    std::string_view op;    ///< its name
    std::string_view label; ///< of the button
    std::string_view help;
    /// `color` is in the operator's space. False where it says nothing of these values.
    bool (*put)(lutlib::Operation& operation, lutlib::RgbD color,
                const lutlib::OpContext& context) = nullptr;
};
std::span<const Picker> pickers();

} // namespace preview::editor
