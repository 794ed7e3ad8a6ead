// The recipe: its operators as their descriptors tell, in their order.
#include "preview/editor/search.h"
#include "preview/look/look_file.h"
#include "preview/panels/parameter_control.h"
#include "preview/panels/ui.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace preview::panels {

namespace {

using lutlib::Operation;
using lutlib::Parameter;
using lutlib::ParameterKind;
using lutlib::RgbD;

enum class Change { none, up, down, remove };

/// The buttons on the right of an operator's heading.
Change operation_buttons(Ui& ui, Operation& operation, const std::string& place, bool is_first,
                         bool is_last) {
    Change change = Change::none;
    ImGui::Checkbox("on", &operation.enabled);
    mark(ui, place + ".on");
    ImGui::SameLine();
    if (ImGui::ArrowButton("up", ImGuiDir_Up) && !is_first) {
        change = Change::up;
    }
    mark(ui, place + ".up");
    ImGui::SameLine();
    if (ImGui::ArrowButton("down", ImGuiDir_Down) && !is_last) {
        change = Change::down;
    }
    mark(ui, place + ".down");
    ImGui::SameLine();
    if (ImGui::Button("Reset")) {
        operation.values = lutlib::default_operation(*operation.op).values;
    }
    mark(ui, place + ".reset");
    ImGui::SameLine();
    if (ImGui::Button("Remove")) {
        change = Change::remove;
    }
    mark(ui, place + ".remove");
    return change;
}

Change operation_controls(Ui& ui, Operation& operation, std::size_t index, bool is_last,
                          const lutlib::OpContext& context) {
    const lutlib::Op& op = *operation.op;
    const std::string place = "op" + std::to_string(index);
    const std::string heading =
        std::string(op.label) + (operation.enabled ? "" : " (off)") + "###" + place;
    ImGui::PushID(static_cast<int>(index));
    Change change = Change::none;
    const bool open = ImGui::CollapsingHeader(heading.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
    mark(ui, place);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%.*s", static_cast<int>(op.help.size()), op.help.data());
    }
    if (open) {
        change = operation_buttons(ui, operation, place, index == 0, is_last);
        for (std::size_t i = 0; i < op.parameters.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            const Parameter& parameter = op.parameters[i];
            parameter_control(ui, parameter, operation.values[i],
                              place + "." + std::string(parameter.name), context);
            ImGui::PopID();
        }
    }
    ImGui::PopID();
    return change;
}

void add_menu(Ui& ui, lutlib::Recipe& recipe) {
    if (ImGui::Button("Add operator")) {
        ImGui::OpenPopup("operators");
    }
    mark(ui, "add");
    if (!ImGui::BeginPopup("operators")) {
        return;
    }
    for (const lutlib::Op* op : lutlib::ops()) {
        if (ImGui::MenuItem(std::string(op->label).c_str())) {
            add_operation(recipe, *op);
        }
        mark(ui, "add." + std::string(op->name));
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%.*s", static_cast<int>(op->help.size()), op->help.data());
        }
    }
    ImGui::EndPopup();
}

/// A list of rows that what is typed above it narrows, in letters of any case.
template <class Row>
bool searched_choice(Ui& ui, const char* label, const std::string& place,
                     const std::string& current, std::span<const Row* const> rows,
                     const Row*& chosen) {
    const bool open = ImGui::BeginCombo(label, current.c_str(), ImGuiComboFlags_HeightLarge);
    mark(ui, place);
    if (!open) {
        return false;
    }
    if (ImGui::IsWindowAppearing()) {
        ui.search.clear();
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::InputTextWithHint("##search", "search", &ui.search);
    mark(ui, place + ".search");
    bool changed = false;
    for (const Row* const row : rows) {
        const std::string text = std::string(row->label) + " (" + std::string(row->name) + ")";
        if (!is_found(text, ui.search)) {
            continue;
        }
        if (ImGui::Selectable(text.c_str(), row == chosen)) {
            chosen = row;
            changed = true;
        }
        mark(ui, place + "." + std::string(row->name));
    }
    ImGui::EndCombo();
    return changed;
}

/// Of a curve, which brings its own gamut, and of another gamut.
void encoding_choice(Ui& ui, const std::string& label, const std::string& place,
                     lutlib::Encoding& chosen) {
    const lutlib::TransferCurve* curve = chosen.curve;
    if (searched_choice(ui, (label + " curve").c_str(), place + ".curve", std::string(curve->label),
                        lutlib::transfer_curves(), curve)) {
        chosen = {curve, curve->gamut};
    }
    const lutlib::Gamut* gamut = chosen.gamut;
    if (searched_choice(ui, (label + " gamut").c_str(), place + ".gamut", std::string(gamut->label),
                        lutlib::gamuts(), gamut)) {
        chosen.gamut = gamut;
    }
}

void where_looks_stand(Ui& ui, PictureCodes& picture) {
    const bool open = ImGui::BeginCombo("Place", std::string(picture.at->name).c_str());
    mark(ui, "look.at");
    if (!open) {
        return;
    }
    for (const LookAt& row : look_ats) {
        if (ImGui::Selectable(std::string(row.name).c_str(), &row == picture.at)) {
            picture.at = &row;
        }
        mark(ui, "look.at." + std::string(row.name));
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", std::string(row.help).c_str());
        }
    }
    ImGui::EndCombo();
}

void encodings_of_look(Ui& ui, State& state) {
    lutlib::Recipe& recipe = state.recipe;
    encoding_choice(ui, "Picture", "look.picture", state.picture.encoding);
    encoding_choice(ui, "Input", "look.input", recipe.input);
    lutlib::Encoding output = recipe.output_encoding();
    encoding_choice(ui, "Output", "look.output", output);
    if (output != recipe.output_encoding()) {
        recipe.output = output;
    }
    ImGui::Checkbox("Convert between the picture's encoding and the look's",
                    &state.picture.convert);
    mark(ui, "look.convert");
    where_looks_stand(ui, state.picture);
}

} // namespace

void lines(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
        ImGui::TextWrapped("%s", text.c_str());
    }
}

void look_panel(Ui& ui) {
    lutlib::Recipe& recipe = ui.history.draft().recipe;
    ImGui::InputText("Title", &recipe.title);
    encodings_of_look(ui, ui.history.draft());
    ImGui::TextDisabled("Base: %s", recipe.base_lut ? ui.history.draft().base_path.c_str()
                                                    : "none (the identity)");
    lines(ui.history.draft().told);
    add_menu(ui, recipe);
    ImGui::SameLine();
    ImGui::TextDisabled("baked in %.1f ms", ui.facts.bake_milliseconds);
    ImGui::Separator();

    std::size_t changed_at = 0;
    Change change = Change::none;
    for (std::size_t i = 0; i < recipe.operations.size(); ++i) {
        const Change asked = operation_controls(
            ui, recipe.operations[i], i, i + 1 == recipe.operations.size(), context_of(recipe));
        if (asked != Change::none) {
            change = asked;
            changed_at = i;
        }
    }
    switch (change) {
    case Change::none:
        break;
    case Change::up:
        move_operation(recipe, changed_at, changed_at - 1);
        break;
    case Change::down:
        move_operation(recipe, changed_at, changed_at + 1);
        break;
    case Change::remove:
        remove_operation(recipe, changed_at);
        break;
    }
}

} // namespace preview::panels
