#include "preview/panels/operator_controls.h"

#include "preview/editor/picked.h"
#include "preview/panels/color_wheel.h"
#include "preview/panels/curve_editor.h"
#include "preview/panels/eyedropper.h"
#include "preview/panels/parameter_control.h"

#include <imgui.h>

#include <algorithm>

namespace preview::panels {

namespace {

using lutlib::Operation;
using lutlib::Parameter;
using lutlib::ParameterKind;

/// The operator there, which a pick is for; added where it was not in the recipe yet. Null where
/// another stands there by now.
Operation* operation_at(State& state, std::size_t at, const lutlib::Op& op) {
    if (at == state.recipe.operations.size()) {
        add_operation(state.recipe, op);
    }
    const bool is_there =
        at < state.recipe.operations.size() && state.recipe.operations[at].op == &op;
    return is_there ? &state.recipe.operations[at] : nullptr;
}

/// What can be picked of the operator as a whole.
void picker_buttons(Ui& ui, const lutlib::Op& op, std::size_t at, const std::string& place) {
    for (const Picker& picker : pickers()) {
        if (picker.op != op.name || !pick_button(ui, std::string(picker.label),
                                                 std::string(picker.help), place + ".pick")) {
            continue;
        }
        start_pick(
            ui, std::string(picker.help), [&op, &picker, at](Ui& picking, const Probe& probe) {
                State& state = picking.history.draft();
                Operation* const operation = operation_at(state, at, op);
                if (operation != nullptr && !picker.put(*operation, color_into(state, probe, at),
                                                        context_of(state.recipe))) {
                    picking.errors.add("pick another place: this one has no " +
                                       std::string(op.space == lutlib::Space::oklab
                                                       ? "hue"
                                                       : "light that tells a white"));
                }
            });
    }
}

bool is_curve(const Parameter& parameter) {
    return parameter.kind == ParameterKind::curve;
}

} // namespace

void start_picking_knot(Ui& ui, const lutlib::Op& op, std::size_t at, std::size_t parameter,
                        const std::string& plot) {
    const Parameter& row = op.parameters[parameter];
    start_pick(ui, "Click the colour for a knot of " + std::string(op.label),
               [&op, &row, at, parameter, plot](Ui& picking, const Probe& probe) {
                   State& state = picking.history.draft();
                   Operation* const operation = operation_at(state, at, op);
                   if (operation == nullptr) {
                       return;
                   }
                   const double x =
                       place_on_axis(*operation, parameter, color_into(state, probe, at));
                   picking.look.curves[plot].knot = add_knot_on_curve(
                       row, std::get<lutlib::Knots>(operation->values[parameter]), x);
               });
}

bool operator_controls(Ui& ui, Operation& operation, std::size_t at, const std::string& place) {
    const lutlib::Op& op = *operation.op;
    const lutlib::OpContext context = context_of(ui.history.draft().recipe);
    picker_buttons(ui, op, at, place);
    bool changed = color_wheels(ui, op.parameters, operation.values, place);
    // Curves of an operator follow each other and share their axes.
    const auto first = std::find_if(op.parameters.begin(), op.parameters.end(), is_curve);
    const auto last = std::find_if_not(first, op.parameters.end(), is_curve);
    const auto before = static_cast<std::size_t>(first - op.parameters.begin());
    if (const auto count = static_cast<std::size_t>(last - first); count > 0) {
        changed |=
            curve_editor(ui, op.parameters.subspan(before, count),
                         std::span(operation.values).subspan(before, count), place,
                         [&](std::size_t i) { start_picking_knot(ui, op, at, before + i, place); });
    }
    for (std::size_t i = 0; i < op.parameters.size(); ++i) {
        const Parameter& parameter = op.parameters[i];
        if (is_curve(parameter) || parameter.wheel.balance > 0) {
            continue;
        }
        ImGui::PushID(static_cast<int>(i));
        changed |= parameter_control(ui, parameter, operation.values[i],
                                     place + "." + std::string(parameter.name), context);
        ImGui::PopID();
    }
    return changed;
}

} // namespace preview::panels
