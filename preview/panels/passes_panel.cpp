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

} // namespace

void passes_panel(Ui& ui) {
    ui.shows_passes = true;
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
