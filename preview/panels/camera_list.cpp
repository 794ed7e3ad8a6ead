#include "preview/panels/camera_list.h"

#include "preview/panels/tip.h"
#include "preview/panels/ui.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <utility>

namespace preview::panels {

namespace {

/// `forget`: what the right button does to one; null: nothing.
void camera_buttons(Ui& ui, const std::vector<NamedCamera>& cameras, const std::string& place,
                    void (*forget)(Ui& ui, const NamedCamera& camera) = nullptr) {
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Button(cameras[i].name.c_str())) {
            ui.history.draft().orbit = cameras[i].orbit;
        }
        mark(ui, place + std::to_string(i));
        if (forget != nullptr) {
            tip("Goes to this camera; the right button forgets it", {}, false);
            if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
                forget(ui, cameras[i]);
            }
        }
        const float right = ImGui::GetItemRectMax().x;
        if (right + em(6) < ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) {
            ImGui::SameLine();
        }
        ImGui::PopID();
    }
}

} // namespace

void camera_controls(Ui& ui) {
    CameraList& list = ui.cameras;
    list.renew();
    camera_buttons(ui, {{"Camera as at first", ui.facts.usual_orbit}}, "camera.first.");
    camera_buttons(ui, ui.facts.cameras, "camera.");
    camera_buttons(ui, list.kept, "camera.kept.",
                   [](Ui& of, const NamedCamera& camera) { of.cameras.forget = camera.name; });
    if (ImGui::GetCursorPosX() > ImGui::GetCursorStartPos().x) {
        ImGui::NewLine(); // the buttons left room in theirs
    }
    if (ImGui::Button("Keep this camera")) {
        list.keep = {std::exchange(list.name, {}), ui.history.draft().orbit};
    }
    mark(ui, "camera.keep");
    tip("Kept for this scene or model until it is forgotten, in other windows too; without a "
        "window --camera NAME renders it",
        {}, false);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    ImGui::InputTextWithHint("##camera-name", "under a name of yours", &list.name);
    mark(ui, "camera.name");
}

} // namespace preview::panels
