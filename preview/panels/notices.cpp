// What a person must know of files: what could not be read again, what waits to be chosen, what was
// exported and what that lost; and that only a part of the look is shown.
#include "preview/editor/commands.h"
#include "preview/editor/reload.h"
#include "preview/panels/theme.h"
#include "preview/panels/ui.h"

#include <imgui.h>

#include <sstream>

namespace preview::panels {

namespace {

/// Of a bake's report where it went, and what was lost.
std::string short_report(const std::string& report) {
    std::istringstream lines(report);
    std::string out, line;
    std::getline(lines, out);
    while (std::getline(lines, line)) {
        if (line.starts_with("  lost: ")) {
            out += '\n' + line.substr(2);
        }
    }
    return out;
}

void warning(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text,
                          IM_COL32(warning_color[0], warning_color[1], warning_color[2], 255));
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

/// The look is not what is seen.
void solo_notice(const State& state) {
    const auto& operations = state.recipe.operations;
    if (state.solo && *state.solo < operations.size()) {
        warning(std::string(operations[*state.solo].op->label) +
                " is shown alone (S ends that); what is saved or exported is the whole look");
    }
    if (const lutlib::Op* const matte = matte_of(state.recipe)) {
        warning("The matte of " + std::string(matte->label) +
                " is shown in place of the look; untick it before the look is saved or exported");
    }
}

void choices_of_left_behind(Ui& ui) {
    for (std::size_t i = 0; i < ui.left_behind.size(); ++i) {
        const std::string name = "left." + std::to_string(i);
        ImGui::PushID(name.c_str());
        warning("A window ended before its look was saved: " + ui.left_behind[i]);
        if (ImGui::Button("Take it up")) {
            ui.take_left = ui.left_behind[i];
        }
        mark(ui, name + ".take");
        ImGui::SameLine();
        if (ImGui::Button("Delete it")) {
            ui.drop_left = ui.left_behind[i];
        }
        mark(ui, name + ".drop");
        ImGui::PopID();
    }
}

} // namespace

void export_to_engine(Ui& ui) {
    if (ui.engine_folder.empty()) {
        ui.errors.add("name the engine's folder at the start: lutpreview "
                      "--watch-engine-folder DIR");
        return;
    }
    const State& state = ui.history.draft();
    const std::string path = strip_in(ui.engine_folder, state);
    Side side;
    side.engine = engine_lookups()[ui.export_engine];
    const auto write = [&ui, path, side] {
        ui.exported.clear();
        ui.report = export_strip(ui.history.draft(), side, path);
        ui.exported = short_report(ui.report);
    };
    is_replaceable(state, path) ? attempt(ui, write) : attempt_writing(ui, path, write);
}

void notices(Ui& ui) {
    if (ui.offered && !is_offered(ui.history.draft(), *ui.offered)) {
        ui.offered.reset();
    }
    for (std::size_t i = 0; i < ui.notices.size(); ++i) {
        warning(ui.notices[i]);
        mark(ui, "notice." + std::to_string(i));
    }
    choices_of_left_behind(ui);
    if (ui.offered) {
        choice_of_offered(ui);
    }
    solo_notice(ui.history.draft());
    if (!ui.exported.empty()) {
        ImGui::TextWrapped("%s", ui.exported.c_str());
        mark(ui, "exported");
        if (ImGui::Button("Close")) {
            ui.exported.clear();
        }
        mark(ui, "exported.close");
    }
}

} // namespace preview::panels
