// The list of keys and of what the mouse does (F1).
#include "preview/panels/actions.h"

#include <imgui.h>

#include <algorithm>

namespace preview::panels {

namespace {

/// Ends a row that stands for those of nine keys, from 1 on.
constexpr const char* series = " to 9";

/// What is no action of the table: keys that are held, lists, the mouse.
constexpr const char* others[][2] = {
    {"hold A", "side A alone, while held"},
    {"hold B", "side B alone, while held"},
    {"arrows, Enter", "in a list that is narrowed by typing: choose a row, take it"},
    {"drag the line, or the box's sides", "move the border of a comparison"},
    {"with the right button, of a box", "draw another"},
    {"drag the picture", "turn the camera about what it looks at"},
    {"with Shift, or the middle button", "carry both to the side"},
    {"with the right button", "turn the camera where it stands"},
    {"wheel", "the camera nearer or farther; of a picture larger or smaller pixels"},
    {"Ctrl with the wheel", "larger or smaller pixels, of a scene too"},
    {"drag a picture, Ctrl with a scene", "carry what is seen of it, where that is a part"},
    {"point at the picture", "its colour before and after the looks, in the line below"},
    {"drag the cube", "turn it"},
};

} // namespace

std::vector<HelpRow> help_rows() {
    std::vector<HelpRow> out;
    for (const Action& action : actions()) {
        const std::string keys = action.listed.value_or(keys_of(action));
        if (!keys.empty()) {
            out.push_back({keys, action.help + (keys.ends_with(series) ? series : "")});
        }
    }
    for (const auto& row : others) {
        out.push_back({row[0], row[1]});
    }
    return out;
}

void help_window(Ui& ui) {
    if (!ui.shows_help) {
        return;
    }
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({em(2), em(2)}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSizeConstraints(
        {0, 0}, {std::max(room.x - em(4), em(4)), std::max(room.y - em(4), em(4))});
    const bool open = ImGui::Begin("Help", &ui.shows_help, ImGuiWindowFlags_AlwaysAutoResize);
    mark_window(ui, "help");
    if (open && ImGui::BeginTable("keys", 2)) {
        static const std::vector<HelpRow> rows = help_rows();
        for (std::size_t i = 0; i < rows.size(); ++i) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(rows[i].keys.c_str());
            mark(ui, "help." + std::to_string(i));
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(rows[i].help.c_str());
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

} // namespace preview::panels
