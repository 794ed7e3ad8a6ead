// The end of the window, which asks while there is work that no file has.
#include "preview/editor/commands.h"
#include "preview/editor/versions.h"
#include "preview/panels/ui.h"

#include <imgui.h>

namespace preview::panels {

namespace {

constexpr const char* title = "Save before closing?";

/// What would go, a sentence each.
void tell_what_goes(const State& state) {
    if (is_unsaved(state)) {
        ImGui::Text("The changes of %s are in no file.", look_name(state).c_str());
    }
    if (const std::size_t versions = unsaved_versions(state); versions > 0) {
        ImGui::Text(versions == 1 ? "A stored version is in no file: bring it back and save it."
                                  : "%zu stored versions are in no file: bring back and save what "
                                    "you want to keep.",
                    versions);
    }
}

} // namespace

void ask_to_quit(Ui& ui) {
    ui.asks_to_quit = has_unsaved(ui.history.draft());
    ui.quits = !ui.asks_to_quit;
    // One question at a time, or Dear ImGui opens each in place of the other, frame by frame; an
    // export waits for the answer.
    ui.to_replace.clear();
    ui.file_dialog = {};
}

void closing_dialog(Ui& ui) {
    const State& state = ui.history.draft();
    if (ui.quits_when_saved) {
        ui.quits = !is_unsaved(state);
        // An error or a question that was answered otherwise keeps the window.
        ui.quits_when_saved = !ui.quits && asks_anything(ui);
    }
    if (ui.asks_to_quit && !ImGui::IsPopupOpen(title)) {
        ImGui::OpenPopup(title);
    }
    if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
        return;
    }
    tell_what_goes(state);
    bool done = !ui.asks_to_quit;
    ImGui::BeginDisabled(!is_unsaved(state));
    if (ImGui::Button("Save and close")) {
        save(ui);
        ui.quits_when_saved = done = true;
    }
    ImGui::EndDisabled();
    mark(ui, "close.save");
    ImGui::SameLine();
    if (ImGui::Button("Discard and close")) {
        ui.quits = done = true;
    }
    mark(ui, "close.discard");
    ImGui::SameLine();
    if (ImGui::Button("Go on working")) {
        done = true;
    }
    mark(ui, "close.cancel");
    if (done) {
        ui.asks_to_quit = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

} // namespace preview::panels
