// The recipe: its operators as their descriptors tell, in their order, and pages of some of them.
#include "preview/editor/solo.h"
#include "preview/panels/look_parts.h"
#include "preview/panels/operator_controls.h"
#include "preview/panels/searched_list.h"
#include "preview/panels/theme.h"
#include "preview/panels/tip.h"

#include <algorithm>

namespace preview::panels {

namespace {

using lutlib::Operation;

/// What the controls of an operator ask of the list.
struct Change {
    enum class Kind : std::uint8_t { none, move, remove };
    Kind kind = Kind::none;
    std::size_t at = 0, to = 0;
};

/// The buttons of an operator that is open.
Change operation_buttons(Ui& ui, Operation& operation, const std::string& place, std::size_t at,
                         std::size_t count) {
    Change change;
    if (ImGui::ArrowButton("up", ImGuiDir_Up) && at > 0) {
        change = {Change::Kind::move, at, at - 1};
    }
    mark(ui, place + ".up");
    tip("Earlier; so does dragging its heading", {}, false);
    ImGui::SameLine();
    if (ImGui::ArrowButton("down", ImGuiDir_Down) && at + 1 < count) {
        change = {Change::Kind::move, at, at + 1};
    }
    mark(ui, place + ".down");
    tip("Later; so does dragging its heading", {}, false);
    ImGui::SameLine();
    if (ImGui::Button("Reset")) {
        operation.values = lutlib::default_operation(*operation.op).values;
    }
    mark(ui, place + ".reset");
    tip("All values as they usually are", {}, false);
    ImGui::SameLine();
    if (ImGui::Button("Remove")) {
        change = {Change::Kind::remove, at, at};
    }
    mark(ui, place + ".remove");
    opacity_control(ui, "Opacity", "How much of the operator's result is taken", operation.opacity,
                    place + ".opacity");
    return change;
}

/// The operator whose heading is at that height of the window.
std::optional<std::size_t> heading_at(const Ui& ui, std::size_t count, float y) {
    for (std::size_t at = 0; at < count; ++at) {
        const Rect& place = ui.places.at("op" + std::to_string(at));
        if (place.y <= y && y <= place.y + place.height) {
            return at;
        }
    }
    return std::nullopt;
}

/// Dragging a heading onto another puts the operator in its place. After all headings are drawn.
Change dragging(Ui& ui) {
    if (!ui.look.dragged) {
        return {};
    }
    const State& state = ui.history.draft();
    const auto& operations = state.recipe.operations;
    const std::size_t from = *ui.look.dragged;
    const auto onto = heading_at(ui, operations.size(), ImGui::GetIO().MousePos.y);
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        ui.look.dragged.reset();
        return onto && *onto != from ? Change{Change::Kind::move, from, *onto} : Change{};
    }
    if (from < operations.size()) {
        ImGui::SetTooltip("%s", std::string(operations[from].op->label).c_str());
    }
    if (onto && *onto != from) {
        const Rect& place = ui.places.at("op" + std::to_string(*onto));
        const float y = *onto < from ? place.y : place.y + place.height;
        ImGui::GetWindowDrawList()->AddLine({place.x, y}, {place.x + place.width, y},
                                            IM_COL32(235, 235, 235, 255), em(0.2F));
    }
    return {};
}

/// Bypass, solo and the heading; whether the operator is open.
bool heading(Ui& ui, std::size_t at, const std::string& place) {
    State& state = ui.history.draft();
    Operation& operation = state.recipe.operations[at];
    const lutlib::Op& op = *operation.op;
    ImGui::Checkbox("##on", &operation.enabled);
    mark(ui, place + ".on");
    tip("Off: the look does without it (D, of the operator that was clicked last)", "on", false);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    const bool is_alone = state.solo == at;
    const ImVec4 alone = ImGui::ColorConvertU32ToFloat4(
        IM_COL32(warning_color[0], warning_color[1], warning_color[2], 255));
    ImGui::PushStyleColor(ImGuiCol_Text,
                          is_alone ? alone : ImGui::GetStyleColorVec4(ImGuiCol_Text));
    if (ImGui::Button("S")) {
        toggle_solo(state, at);
    }
    ImGui::PopStyleColor();
    mark(ui, place + ".solo");
    tip("Shows it alone (S, of the operator that was clicked last)", "off", false);
    ImGui::SameLine(0, em(0.8F)); // a heading begins left of its place
    const std::string label = std::string(op.label) + (operation.enabled ? "" : " (off)") +
                              (is_identity(operation) ? " (neutral)" : "") + "###" + place;
    ImGui::SetNextItemOpen(ui.look.open[at]);
    ImGui::PushStyleColor(
        ImGuiCol_Header,
        ImGui::GetStyleColorVec4(ui.look.chosen == at ? ImGuiCol_HeaderActive : ImGuiCol_Header));
    const bool is_open = ImGui::CollapsingHeader(label.c_str());
    ImGui::PopStyleColor();
    if (is_open != ui.look.open[at]) {
        ui.look.open[at] = is_open;
        ui.look.chosen = at;
    }
    mark(ui, place);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, em(0.5F))) {
        ui.look.dragged = at;
    }
    if (!ui.look.dragged) {
        tip(op.help, {}, false);
    }
    return is_open;
}

Change operation_rows(Ui& ui, std::size_t at) {
    lutlib::Recipe& recipe = ui.history.draft().recipe;
    Change change;
    const std::string place = "op" + std::to_string(at);
    ImGui::PushID(static_cast<int>(at));
    if (heading(ui, at, place)) {
        Operation& operation = recipe.operations[at];
        change = operation_buttons(ui, operation, place, at, recipe.operations.size());
        if (operator_controls(ui, operation, at, place)) {
            ui.look.chosen = at;
        }
    }
    ImGui::PopID();
    return change;
}

void make(Ui& ui, const Change& change) {
    State& state = ui.history.draft();
    std::vector<bool>& open = ui.look.open;
    const auto place = [&open](std::size_t at) {
        return open.begin() + static_cast<std::ptrdiff_t>(at);
    };
    switch (change.kind) {
    case Change::Kind::none:
        return;
    case Change::Kind::move: {
        const bool is_open = open[change.at];
        open.erase(place(change.at));
        open.insert(place(change.to), is_open);
        ui.look.chosen = change.to;
        move_operation(state, change.at, change.to);
        return;
    }
    case Change::Kind::remove:
        open.erase(place(change.at));
        ui.look.chosen.reset();
        remove_operation(state, change.at);
        return;
    }
}

void add_menu(Ui& ui) {
    lutlib::Recipe& recipe = ui.history.draft().recipe;
    if (ImGui::Button("Add operator")) {
        ImGui::OpenPopup("operators");
    }
    mark(ui, "add");
    tip("At the end of the look", {}, false);
    ImGui::SetNextWindowSizeConstraints({0, 0}, {em(40), ImGui::GetIO().DisplaySize.y * 0.9F});
    if (!ImGui::BeginPopup("operators")) {
        return;
    }
    if (const lutlib::Op* const op = searched_rows<lutlib::Op>(ui, "add", lutlib::ops(), nullptr)) {
        add_operation(recipe, *op);
        ui.look.open.resize(recipe.operations.size());
        ui.look.open.back() = true;
        ui.look.chosen = recipe.operations.size() - 1;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

void page_tabs(Ui& ui) {
    const auto pages = look_pages();
    for (std::size_t i = 0; i < pages.size(); ++i) {
        if (i > 0) {
            ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
        }
        const bool is_seen = ui.look.page == i;
        ImGui::PushStyleColor(
            ImGuiCol_Button, ImGui::GetStyleColorVec4(is_seen ? ImGuiCol_TabActive : ImGuiCol_Tab));
        if (ImGui::Button(std::string(pages[i].name).c_str())) {
            ui.look.page = i;
        }
        ImGui::PopStyleColor();
        mark(ui, "page." + std::string(pages[i].name));
        tip(pages[i].help, {}, false);
    }
    ImGui::Separator();
}

void list_of_operators(Ui& ui) {
    State& state = ui.history.draft();
    ImGui::InputText("Title", &state.recipe.title);
    encodings_of_look(ui);
    ImGui::TextDisabled("Base: %s",
                        state.recipe.base_lut ? state.base_path.c_str() : "none (the identity)");
    lines(state.told);
    opacity_control(ui, "Opacity of the look", "How much of the whole look is taken",
                    state.recipe.opacity, "look.opacity");
    add_menu(ui);
    ImGui::SameLine();
    ImGui::TextDisabled("baked in %.1f ms", ui.facts.bake_milliseconds);
    ImGui::Separator();
    Change change;
    for (std::size_t at = 0; at < state.recipe.operations.size(); ++at) {
        const Change asked = operation_rows(ui, at);
        change = asked.kind != Change::Kind::none ? asked : change;
    }
    const Change dropped = dragging(ui);
    make(ui, dropped.kind != Change::Kind::none ? dropped : change);
}

} // namespace

void lines(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
        ImGui::TextWrapped("%s", text.c_str());
    }
}

void told_lines(Ui& ui, const std::vector<std::string>& texts, const std::string& place) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
        ImGui::TextWrapped("%s", texts[i].c_str());
        mark(ui, place + std::to_string(i));
    }
}

void look_panel(Ui& ui) {
    const std::size_t count = ui.history.draft().recipe.operations.size();
    ui.look.open.resize(count); // undo and files change the list too
    if (ui.look.chosen && *ui.look.chosen >= count) {
        ui.look.chosen.reset();
    }
    page_tabs(ui);
    const LookPage& page = look_pages()[ui.look.page];
    page.ops.empty() ? list_of_operators(ui) : page_of_operators(ui, page);
}

} // namespace preview::panels
