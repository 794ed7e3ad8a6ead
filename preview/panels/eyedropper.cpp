#include "preview/panels/eyedropper.h"

#include "preview/panels/tip.h"

#include <imgui.h>

#include <utility>

namespace preview::panels {

namespace {

/// Frames in flight, the one that is drawn next and one more: by then what was measured is of the
/// place that was clicked.
constexpr int frames_until_measured = 5;

void say(const std::string& words) {
    const ImVec2 corner = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    const float room = em(0.5F);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + size.x + 2 * room, corner.y + size.y + 2 * room},
                       IM_COL32(20, 20, 20, 220));
    list.AddText({corner.x + room, corner.y + room}, IM_COL32(235, 235, 235, 255), words.c_str());
}

} // namespace

void start_pick(Ui& ui, std::string words, std::function<void(Ui& ui, const Probe& probe)> use) {
    ui.pick = Pick{.words = std::move(words), .use = std::move(use)};
}

bool pick_button(Ui& ui, const std::string& label, const std::string& help,
                 const std::string& place) {
    const bool is_pressed = ImGui::Button((label + "##" + place).c_str());
    mark(ui, place);
    tip(help, {}, false);
    return is_pressed;
}

bool takes_mouse_for_pick(Ui& ui) {
    if (!ui.pick) {
        return false;
    }
    Pick& pick = *ui.pick;
    if (ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    say(pick.words + " (Esc: not)");
    if (!pick.place && ui.pointer && ImGui::IsItemActivated()) {
        pick.place = ui.pointer;
    }
    if (!pick.place) {
        return true;
    }
    ui.pointer = pick.place;
    // Not before the button is up: what it changes is one step of undo, and the drag is no
    // camera's.
    if (++pick.frames < frames_until_measured || ImGui::IsItemActive()) {
        return true;
    }
    const Pick done = *std::exchange(ui.pick, std::nullopt);
    if (ui.facts.measured.probe) {
        done.use(ui, *ui.facts.measured.probe);
    }
    return true;
}

} // namespace preview::panels
