// The line under the picture: the colour under the mouse before the looks and after each side's, as
// codes, how far apart they are and, in a wide window, as values.
#include "preview/panels/ui.h"

#include <imgui.h>

namespace preview::panels {

namespace {

constexpr float wide = 75; // heights of the text, that hold the values too

void swatch(const char* name, lutlib::RgbD color, bool with_values) {
    const Codes codes = codes_of(color);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + side, corner.y + side},
                                              IM_COL32(codes.r, codes.g, codes.b, 255));
    ImGui::Dummy({side, side});
    ImGui::SameLine(0, em(0.43F));
    ImGui::Text("%s %3d %3d %3d", name, codes.r, codes.g, codes.b);
    if (with_values) {
        ImGui::SameLine(0, em(0.43F));
        ImGui::TextDisabled("%.4f %.4f %.4f", color.r, color.g, color.b);
    }
    ImGui::SameLine(0, em(1.14F));
}

} // namespace

void status_line(Ui& ui, const Rect& area) {
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {em(0.57F), em(0.36F)});
    ImGui::Begin("Status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    if (ui.pointer && ui.facts.measured.probe) {
        const Probe& probe = *ui.facts.measured.probe;
        const ProbeDifferences differences = differences_of(probe);
        ImGui::TextDisabled("%4d, %4d", ui.pointer->x, ui.pointer->y);
        ImGui::SameLine(0, em(1.14F));
        swatch("before", probe.before, area.width > em(wide));
        swatch("A", probe.a, area.width > em(wide));
        swatch("B", probe.b, area.width > em(wide));
        ImGui::Text("dE2000 A %.2f  B %.2f  A-B %.2f", differences.before_a, differences.before_b,
                    differences.a_b);
    } else {
        ImGui::TextDisabled("point at the picture for its colour before and after the looks");
    }
    ImGui::End();
    ui.places["status"] = area;
}

} // namespace preview::panels
