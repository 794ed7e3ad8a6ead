// What a person must know of files: what could not be read again, what waits to be chosen.
#include "preview/editor/reload.h"
#include "preview/panels/ui.h"

#include <imgui.h>

namespace preview::panels {

namespace {

void warning(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(255, 190, 60, 255));
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

void choice_of_offered(Ui& ui) {
    warning(ui.offered->path() +
            " has changed on disk; the changes made here are not saved and are kept");
    mark(ui, "offer");
    const bool takes = ImGui::Button("Take the file's");
    mark(ui, "offer.take");
    ImGui::SameLine();
    const bool keeps = ImGui::Button("Keep mine");
    mark(ui, "offer.keep");
    if (takes) {
        attempt(ui, [&] { take_offered(ui.history, *ui.offered); });
    }
    if (takes || keeps) {
        ui.offered.reset();
    }
}

} // namespace

void notices(Ui& ui) {
    if (ui.offered && !is_offered(ui.history.draft(), *ui.offered)) {
        ui.offered.reset();
    }
    for (std::size_t i = 0; i < ui.notices.size(); ++i) {
        warning(ui.notices[i]);
        mark(ui, "notice." + std::to_string(i));
    }
    if (ui.offered) {
        choice_of_offered(ui);
    }
}

} // namespace preview::panels
