// What each pass costs, kept or left out and why, and a switch for every effect.
#include "preview/panels/ui.h"

#include <imgui.h>

namespace preview::panels {

namespace {

void effect_switches(Ui& ui) {
    EffectSet& without = ui.history.draft().without;
    for (const EffectInfo& row : effects) {
        bool is_on = !without.has(row.effect);
        if (ImGui::Checkbox(std::string(row.label).c_str(), &is_on)) {
            without.set(row.effect, !is_on);
        }
        mark(ui, "effect." + std::string(row.name));
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("off: %s", std::string(row.help).c_str());
        }
    }
}

/// Which intermediate is shown in place of the picture.
void debug_view_list(Ui& ui) {
    const std::string none = "the picture";
    const bool open =
        ImGui::BeginCombo("Show", ui.debug_view.empty() ? none.c_str() : ui.debug_view.c_str());
    mark(ui, "debug-view");
    if (!open) {
        return;
    }
    if (ImGui::Selectable(none.c_str(), ui.debug_view.empty())) {
        ui.debug_view.clear();
    }
    mark(ui, "debug-view.none");
    for (const Option& row : ui.facts.debug_views) {
        const std::string name(row.name);
        if (ImGui::Selectable((name + ": " + std::string(row.text)).c_str(),
                              name == ui.debug_view)) {
            ui.debug_view = name;
        }
        mark(ui, "debug-view." + name);
    }
    ImGui::EndCombo();
}

} // namespace

void passes_panel(Ui& ui) {
    ui.shows_passes = true;
    debug_view_list(ui);
    effect_switches(ui);
    ImGui::Separator();
    double total = 0;
    if (ImGui::BeginTable("passes", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV)) {
        ImGui::TableSetupColumn("pass");
        ImGui::TableSetupColumn("GPU ms", ImGuiTableColumnFlags_WidthFixed,
                                ImGui::GetFontSize() * 6);
        ImGui::TableHeadersRow();
        for (const PassTime& pass : ui.facts.passes) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(pass.name.c_str());
            ImGui::TableNextColumn();
            ImGui::Text("%.3f", pass.milliseconds);
            total += pass.milliseconds;
        }
        ImGui::TableNextColumn();
        ImGui::TextUnformatted("frame");
        ImGui::TableNextColumn();
        ImGui::Text("%.3f", total);
        ImGui::EndTable();
    }
    ImGui::Separator();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(ui.facts.explanation.c_str());
    ImGui::PopTextWrapPos();
}

} // namespace preview::panels
