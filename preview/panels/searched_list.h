// Lists that what is typed above them narrows, in letters of any case.
#pragma once

#include "preview/editor/search.h"
#include "preview/panels/ui.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <span>
#include <string>

namespace preview::panels {

/// In an open list or popup: the field, and the row that was chosen, else null. `current` is the
/// one that is chosen now, or null.
template <class Row>
const Row* searched_rows(Ui& ui, const std::string& place, std::span<const Row* const> rows,
                         const Row* current) {
    if (ImGui::IsWindowAppearing()) {
        ui.search.clear();
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::InputTextWithHint("##search", "search", &ui.search);
    mark(ui, place + ".search");
    const Row* chosen = nullptr;
    for (const Row* const row : rows) {
        const std::string text = std::string(row->label) + " (" + std::string(row->name) + ")";
        std::string help;
        if constexpr (requires { row->help; }) {
            help = row->help;
        }
        if (!is_found(text + " " + help, ui.search)) {
            continue;
        }
        if (ImGui::Selectable(text.c_str(), row == current)) {
            chosen = row;
        }
        mark(ui, place + "." + std::string(row->name));
        if (!help.empty() && ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", help.c_str());
        }
    }
    return chosen;
}

/// A combo of such a list; whether another row was chosen.
template <class Row>
bool searched_choice(Ui& ui, const std::string& label, const std::string& place,
                     std::span<const Row* const> rows, const Row*& chosen) {
    const bool is_open = ImGui::BeginCombo(label.c_str(), std::string(chosen->label).c_str(),
                                           ImGuiComboFlags_HeightLarge);
    mark(ui, place);
    if (!is_open) {
        return false;
    }
    const Row* const asked = searched_rows(ui, place, rows, chosen);
    ImGui::EndCombo();
    chosen = asked != nullptr ? asked : chosen;
    return asked != nullptr;
}

} // namespace preview::panels
