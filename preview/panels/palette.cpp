#include "preview/panels/palette.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace preview::panels {

namespace {

/// What the keys do to the place of the chosen row.
std::size_t moved(std::size_t at, std::size_t count) {
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    if (count == 0) {
        return 0;
    }
    at = std::min(at, count - 1);
    if (pressed(ImGuiKey_DownArrow)) {
        return (at + 1) % count;
    }
    return pressed(ImGuiKey_UpArrow) ? (at + count - 1) % count : at;
}

} // namespace

void palette(Ui& ui) {
    if (!ui.shows_palette) {
        return;
    }
    static std::vector<Action> all; // as it opened
    constexpr std::size_t most_rows = 14;
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const float width = std::min(em(44), room.x - em(1));
    ImGui::SetNextWindowPos({room.x / 2, em(2)}, ImGuiCond_Always, {0.5F, 0});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::Begin("What to do", nullptr,
                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoSavedSettings);
    if (ImGui::IsWindowAppearing()) {
        ui.cameras.renew();
        all = commands(ui);
        ui.palette_text.clear();
        ui.palette_at = 0;
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    const std::string before = ui.palette_text;
    const bool entered =
        ImGui::InputTextWithHint("##typed", "type what you want to do, Enter does it",
                                 &ui.palette_text, ImGuiInputTextFlags_EnterReturnsTrue);
    mark(ui, "palette.search");
    const std::vector<std::size_t> found = found_commands(all, ui.palette_text);
    const bool is_moved = ui.palette_text == before;
    ui.palette_at = is_moved ? moved(ui.palette_at, found.size()) : 0;
    const float height =
        ImGui::GetTextLineHeightWithSpacing() *
        static_cast<float>(std::min(std::max(found.size(), std::size_t{1}), most_rows));
    const Action* chosen = nullptr;
    ImGui::BeginChild("found", {0, std::min(height, std::max(room.y - em(8), em(2)))});
    for (std::size_t row = 0; row < found.size(); ++row) {
        const Action& action = all[found[row]];
        ImGui::PushID(static_cast<int>(row));
        if (ImGui::Selectable(action.help.c_str(), row == ui.palette_at)) {
            chosen = &action;
        }
        if (row < most_rows) {
            mark(ui, "palette." + std::to_string(row));
        }
        if (row == ui.palette_at && !ImGui::IsItemVisible()) {
            ImGui::SetScrollHereY();
        }
        const std::string keys = keys_of(action);
        if (!keys.empty()) {
            ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(keys.c_str()).x);
            ImGui::TextDisabled("%s", keys.c_str());
        }
        ImGui::PopID();
    }
    if (found.empty()) {
        ImGui::TextDisabled("nothing has all these words");
    }
    ImGui::EndChild();
    ImGui::End();
    if (entered && ui.palette_at < found.size()) {
        chosen = &all[found[ui.palette_at]];
    }
    if (chosen != nullptr) {
        ui.shows_palette = false;
        chosen->act(ui);
    }
}

} // namespace preview::panels
