// The versions of the look: stored, brought back, and shown on side A.
#include "preview/editor/versions.h"
#include "preview/panels/still_controls.h"
#include "preview/panels/thumbnail.h"
#include "preview/panels/ui.h"

#include <imgui.h>

namespace preview::panels {

namespace {

constexpr float version_share = 0.6F; // of the full size of a small picture

/// What is shown under the version, which a click on it brings back.
void version_picture(Ui& ui, State& state, std::size_t place) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("picture", {em(thumbnail_width) * version_share,
                                           em(thumbnail_height) * version_share})) {
        recall_version(state, place);
    }
    mark(ui, "version." + std::to_string(place + 1) + ".picture");
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("a click brings it back");
    }
    place_thumbnail(ui, {ThumbnailKind::version, std::to_string(place)}, low.x, low.y,
                    version_share);
}

void version_row(Ui& ui, State& state, std::size_t place) {
    const std::string number = std::to_string(place + 1);
    const std::shared_ptr<const editor::Version> version = state.versions[place];
    ImGui::PushID(number.c_str());
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(number.c_str());
    ImGui::TableNextColumn();
    if (version) {
        version_picture(ui, state, place);
    }
    ImGui::TableNextColumn();
    if (version) {
        ImGui::TextWrapped("%s%s", name_of(*version).c_str(),
                           same(version->recipe, state.recipe) ? " (as it is now)" : "");
    } else {
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("empty");
    }
    mark(ui, "version." + number);
    if (!version) {
        ImGui::SameLine(); // all nine are to be seen
    }
    if (ImGui::Button("Store")) {
        store_version(state, place);
    }
    mark(ui, "version." + number + ".store");
    ImGui::BeginDisabled(!version);
    ImGui::SameLine();
    if (ImGui::Button("Recall")) {
        recall_version(state, place);
    }
    mark(ui, "version." + number + ".recall");
    ImGui::SameLine();
    if (ImGui::Button("On A")) {
        show_version(state, place, 0);
    }
    mark(ui, "version." + number + ".compare");
    ImGui::EndDisabled();
    ImGui::PopID();
}

} // namespace

void versions_panel(Ui& ui) {
    ImGui::TextWrapped("Ctrl with a number stores the look there, the number brings it back, Shift "
                       "with it shows it on side A. They stay until the window closes; undo takes "
                       "each step back.");
    if (!ImGui::BeginTable("versions", 3, ImGuiTableFlags_RowBg)) {
        return;
    }
    ImGui::TableSetupColumn("number", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("picture", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("look", ImGuiTableColumnFlags_WidthStretch);
    State& state = ui.history.draft();
    for (std::size_t place = 0; place < version_count; ++place) {
        ImGui::TableNextRow();
        version_row(ui, state, place);
    }
    ImGui::EndTable();
    show_thumbnails(ui);
    ImGui::Separator();
    still_controls(ui);
}

} // namespace preview::panels
