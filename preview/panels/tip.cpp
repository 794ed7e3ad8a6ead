#include "preview/panels/tip.h"

#include "preview/panels/ui.h"

#include <imgui.h>

namespace preview::panels {

void tip(std::string_view help, const std::string& usual, bool is_number) {
    if (!ImGui::IsItemHovered()) {
        return;
    }
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(em(28));
    if (!help.empty()) {
        ImGui::TextUnformatted(help.data(), help.data() + help.size());
    }
    if (!usual.empty()) {
        ImGui::TextDisabled("usually %s", usual.c_str());
    }
    if (is_number) {
        ImGui::TextDisabled("Ctrl+click to type a number");
    }
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void idle_tip(std::string_view why) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        ImGui::BeginTooltip();
        ImGui::TextUnformatted("It changes nothing here:");
        ImGui::TextUnformatted(why.data(), why.data() + why.size());
        ImGui::EndTooltip();
    }
}

} // namespace preview::panels
