// The lights of the scene, by the table of their controls.
#include "preview/panels/camera_list.h"
#include "preview/panels/thumbnail.h"
#include "preview/panels/tip.h"
#include "preview/panels/ui.h"
#include "preview/scene/light_controls.h"
#include "preview/scene/scene.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace preview::panels {

namespace {

/// As the scene has it, with the unit; nothing of a light that it has not.
std::string usual_text(const LightControl& control, const PointLight* usual) {
    if (usual == nullptr) {
        return std::string(control.unit);
    }
    const glm::vec3 value = control.get(*usual);
    if (control.kind == LightControl::Kind::flag) {
        return value.x != 0 ? "on" : "off";
    }
    const std::string numbers = components(control.kind) == 3
                                    ? fmt::format("{:.4g} {:.4g} {:.4g}", value.x, value.y, value.z)
                                    : fmt::format("{:.4g}", value.x);
    return numbers + " " + std::string(control.unit);
}

void control_row(Ui& ui, const LightControl& control, PointLight& light, const PointLight* usual,
                 const std::string& place) {
    const std::string label(control.label);
    const std::string_view idle =
        control.idle_because != nullptr ? control.idle_because(light, true) : "";
    glm::vec3 value = control.get(light);
    bool changed = false;
    ImGui::BeginDisabled(!idle.empty());
    switch (control.kind) {
    case LightControl::Kind::flag: {
        bool is_set = value.x != 0;
        changed = ImGui::Checkbox(label.c_str(), &is_set);
        value.x = is_set ? 1.0F : 0.0F;
        break;
    }
    case LightControl::Kind::number:
        // Over many decades a drag changes by shares of the value.
        changed =
            control.logarithmic
                ? ImGui::DragFloat(label.c_str(), &value.x, std::max(value.x, control.min) / 100,
                                   control.min, control.max, "%.4g", ImGuiSliderFlags_AlwaysClamp)
                : ImGui::SliderFloat(label.c_str(), &value.x, control.min, control.max, "%.4g",
                                     ImGuiSliderFlags_AlwaysClamp);
        break;
    case LightControl::Kind::color:
        changed = ImGui::ColorEdit3(label.c_str(), &value.x, ImGuiColorEditFlags_Float);
        break;
    case LightControl::Kind::point:
        changed = ImGui::DragFloat3(label.c_str(), &value.x, 0.01F, control.min, control.max,
                                    "%.2f", ImGuiSliderFlags_AlwaysClamp);
        break;
    }
    ImGui::EndDisabled();
    mark(ui, place);
    if (idle.empty()) {
        tip(control.help, usual_text(control, usual), control.kind != LightControl::Kind::flag);
    } else {
        idle_tip(idle);
    }
    if (changed) {
        control.set(light, value);
    }
}

/// A built-in scene as it looks, its name and what it is; whether it was chosen.
bool scene_row(Ui& ui, const SceneInfo& row) {
    constexpr float share = 0.5F; // of the full size of a small picture
    const std::string name(row.name);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = em(thumbnail_height) * share;
    const bool is_chosen =
        ImGui::Selectable(("##" + name).c_str(), row.name == ui.facts.input, 0, {0, height});
    mark(ui, "scene." + name);
    const ImVec2 next = ImGui::GetCursorScreenPos();
    place_thumbnail(ui, {ThumbnailKind::scene, name}, low.x, low.y, share);
    ImGui::SetCursorScreenPos({low.x + em(thumbnail_width) * share + em(0.5F),
                               low.y + (height - ImGui::GetTextLineHeight()) / 2});
    ImGui::TextUnformatted((name + ": " + std::string(row.help)).c_str());
    ImGui::SetCursorScreenPos(next);
    return is_chosen;
}

/// The built-in scenes; files come through the panel Files.
void scene_list(Ui& ui) {
    const bool open =
        ImGui::BeginCombo("Scene", ui.facts.input.c_str(), ImGuiComboFlags_HeightLargest);
    mark(ui, "scene.list");
    if (!open) {
        return;
    }
    for (const SceneInfo& row : scenes()) {
        if (scene_row(ui, row)) {
            ui.to_open.emplace_back(row.name);
        }
    }
    show_thumbnails(ui);
    ImGui::EndCombo();
}

/// The moment of a built-in scene.
void time_controls(Ui& ui) {
    if (scene_named(ui.facts.input) == nullptr) {
        return;
    }
    if (ImGui::Button(ui.plays ? "Stop" : "Play")) {
        ui.plays = !ui.plays;
    }
    mark(ui, "time.play");
    ImGui::SameLine();
    auto seconds = static_cast<float>(ui.seconds);
    if (ImGui::DragFloat("Time (s)", &seconds, 0.05F, 0, 1e4F, "%.2f",
                         ImGuiSliderFlags_AlwaysClamp)) {
        ui.seconds = static_cast<double>(seconds);
    }
    mark(ui, "time");
    tip("The moment that the scene and its effects show", "0 s");
}

} // namespace

void scene_panel(Ui& ui) {
    std::vector<PointLight>& lights = ui.history.draft().lights;
    scene_list(ui);
    if (ui.facts.is_scene) {
        camera_controls(ui);
        time_controls(ui);
    }
    for (const std::string& line : ui.facts.left_out) {
        ImGui::TextWrapped("Left out: %s", line.c_str());
    }
    told_lines(ui, ui.facts.told, "told.");
    if (!ui.facts.is_scene) {
        ImGui::TextUnformatted("A picture is shown: it has no lights.");
    }
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const std::string name = light_name(lights[i], i);
        ImGui::PushID(static_cast<int>(i));
        const bool open =
            ImGui::CollapsingHeader(("Light " + name).c_str(), ImGuiTreeNodeFlags_DefaultOpen);
        mark(ui, "light." + name);
        if (open) {
            for (const LightControl& control : light_controls()) {
                control_row(ui, control, lights[i],
                            i < ui.facts.usual_lights.size() ? &ui.facts.usual_lights[i] : nullptr,
                            "light." + name + "." + std::string(control.name));
            }
        }
        ImGui::PopID();
    }
}

} // namespace preview::panels
