// The colours that were kept under the mouse, with their figures and how far they are apart.
#include "preview/panels/tip.h"
#include "preview/panels/ui.h"

#include <imgui.h>

#include <fmt/format.h>

namespace preview::panels {

namespace {

struct PickedSide {
    const char* name;
    lutlib::RgbD Probe::*color;
};
constexpr PickedSide sides[] = {{"before", &Probe::before}, {"A", &Probe::a}, {"B", &Probe::b}};

void side_row(const PickedSide& side, const PickedColor& picked, double white) {
    const ColorFigures figures = figures_of(picked.probe.*side.color, white);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float length = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddRectFilled(
        corner, {corner.x + length, corner.y + length},
        IM_COL32(figures.codes.r, figures.codes.g, figures.codes.b, 255));
    ImGui::Dummy({length, length});
    ImGui::SameLine();
    ImGui::TextUnformatted(side.name);
    for (const std::string& text :
         {codes_text(figures), linear_text(figures), luminance_text(figures), lab_text(figures)}) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(text.c_str());
        if (ImGui::IsItemClicked()) {
            ImGui::SetClipboardText(text.c_str());
        }
    }
}

void color_rows(Ui& ui, std::size_t at) {
    const PickedColor& picked = ui.picked[at];
    const ProbeDifferences apart = differences_of(picked.probe);
    ImGui::TextDisabled("%d, %d", picked.place.x, picked.place.y);
    ImGui::SameLine();
    ImGui::Text("dE2000 A %.2f  B %.2f  A-B %.2f", apart.before_a, apart.before_b, apart.a_b);
    if (at + 1 < ui.picked.size()) {
        const auto lab = [](const PickedColor& color) {
            return lutlib::lab_from_srgb(lutlib::saturate(color.probe.b));
        };
        ImGui::SameLine();
        ImGui::Text("B from the one below %.2f",
                    lutlib::delta_e_2000(lab(picked), lab(ui.picked[at + 1])));
    }
    if (ImGui::BeginTable("figures", 5, ImGuiTableFlags_SizingFixedFit)) {
        for (const PickedSide& side : sides) {
            side_row(side, picked, static_cast<double>(ui.display_white));
        }
        ImGui::EndTable();
    }
    mark(ui, "color." + std::to_string(at));
}

} // namespace

void pick_color(Ui& ui) {
    if (!ui.pointer || !ui.facts.measured.probe) {
        ui.errors.add("point at the picture first: the colour under the mouse is kept");
        return;
    }
    pick(ui.picked, {*ui.pointer, *ui.facts.measured.probe});
}

void colors_panel(Ui& ui) {
    ImGui::TextWrapped(
        "C keeps the colour under the mouse: its codes, light, luminance and CIELAB. "
        "Click a figure to copy it.");
    ImGui::SliderFloat("Display's white (cd/m2)", &ui.display_white,
                       static_cast<float>(least_display_white),
                       static_cast<float>(most_display_white), "%.4g",
                       ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
    mark(ui, "color.white");
    tip("What luminances are told for, also by scopes in PQ",
        fmt::format("{:.4g} cd/m2", usual_display_white));
    if (!ui.picked.empty() && ImGui::Button("Forget them")) {
        ui.picked.clear();
    }
    mark(ui, "color.forget");
    for (std::size_t i = 0; i < ui.picked.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        ImGui::Separator();
        color_rows(ui, i);
        ImGui::PopID();
    }
}

} // namespace preview::panels
