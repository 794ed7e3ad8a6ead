// The look of a side as the cube of its nodes, to be turned with the mouse.
#include "preview/look/cube_settings.h"
#include "preview/panels/ui.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace preview::panels {

namespace {

constexpr int least_nodes = 5, most_nodes = 33;

ImU32 color_of(Rgb8 color, float opacity = 1) {
    return IM_COL32(color[0], color[1], color[2], static_cast<int>(255 * opacity));
}

void put(ImDrawList& list, ImVec2 corner, const CubeLine& line) {
    list.AddLine({corner.x + line.x0, corner.y + line.y0}, {corner.x + line.x1, corner.y + line.y1},
                 color_of(line.color, line.opacity), line.width);
}

/// Squares of a circle's area: a tenth of its vertices.
void put(ImDrawList& list, ImVec2 corner, const CubeDot& dot) {
    const float reach = dot.radius * 0.886F;
    list.AddRectFilled({corner.x + dot.x - reach, corner.y + dot.y - reach},
                       {corner.x + dot.x + reach, corner.y + dot.y + reach}, color_of(dot.color));
}

/// The nodes of the side, thinned anew when the look or the number changes.
const NodeCloud& nodes_of(const std::shared_ptr<const lutlib::Lut>& table, int most) {
    static std::shared_ptr<const lutlib::Lut> kept_table;
    static int kept_most = 0;
    static NodeCloud kept;
    if (kept_most != most || kept_table != table) {
        kept = cube_nodes(table ? *table : lutlib::Lut{}, most);
        kept_table = table;
        kept_most = most;
    }
    return kept;
}

void look_from(CubeView& view, float turn, float tilt) {
    view.turn = turn;
    view.tilt = tilt;
    view.zoom = 1;
}

void controls(Ui& ui, CubeChoice& choice) {
    constexpr const char* names[] = {"A", "B"};
    for (std::size_t i = 0; i < 2; ++i) {
        if (ImGui::RadioButton((std::string("Side ") + names[i]).c_str(), choice.side == i)) {
            choice.side = i;
        }
        mark(ui, std::string("cube.side") + names[i]);
        ImGui::SameLine();
    }
    ImGui::NewLine();
    for (const SwitchRow<CubeView>& row : cube_switches()) {
        ImGui::Checkbox(std::string(row.label).c_str(), &row.of(choice.view));
        mark(ui, "setting." + std::string(row.flag));
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", std::string(row.help).c_str());
        }
    }
    ImGui::SliderInt("Nodes of an axis", &choice.per_side, least_nodes, most_nodes, "at most %d",
                     ImGuiSliderFlags_AlwaysClamp);
    mark(ui, "cube.nodes");
    if (ImGui::Button("Front")) {
        look_from(choice.view, CubeView{}.turn, CubeView{}.tilt);
    }
    mark(ui, "cube.front");
    ImGui::SameLine();
    if (ImGui::Button("From above")) {
        look_from(choice.view, 0, 90);
    }
    mark(ui, "cube.above");
}

void set_within_range(CubeView& view, std::string_view flag, float value) {
    const NumberRow<CubeView>& row = row_of(cube_numbers(), flag);
    row.of(view) = std::clamp(value, static_cast<float>(row.min), static_cast<float>(row.max));
}

void turn_by_mouse(CubeView& view) {
    constexpr float degrees_per_pixel = 0.5F, zoom_per_notch = 1.1F;
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive()) {
        view.turn = std::remainder(view.turn - degrees_per_pixel * io.MouseDelta.x, 360.0F);
        set_within_range(view, "cube-tilt", view.tilt + degrees_per_pixel * io.MouseDelta.y);
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
        set_within_range(view, "cube-zoom", view.zoom * std::pow(zoom_per_notch, io.MouseWheel));
    }
}

} // namespace

void cube_panel(Ui& ui) {
    CubeChoice& choice = ui.history.draft().cube;
    controls(ui, choice);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float footer = ImGui::GetTextLineHeightWithSpacing();
    const ImVec2 size(std::max(room.x, em(4)),
                      std::clamp(room.y - footer, em(4), std::max(room.x, em(4)) * 1.25F));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("cube", size);
    mark(ui, "cube");
    turn_by_mouse(choice.view);

    static CubeDrawing drawing; // kept for its capacity
    const auto start = std::chrono::steady_clock::now();
    const NodeCloud& nodes = nodes_of(ui.facts.tables[choice.side], choice.per_side);
    draw_cube(nodes, choice.view, size.x, size.y, drawing);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end(corner.x + size.x, corner.y + size.y);
    list.AddRectFilled(corner, end, color_of(cube_ground));
    list.PushClipRect(corner, end, true);
    for (const CubeLine& line : drawing.behind) {
        put(list, corner, line);
    }
    for (const CubeDot& dot : drawing.dots) {
        put(list, corner, dot);
    }
    for (const CubeLine& line : drawing.before) {
        put(list, corner, line);
    }
    list.PopClipRect();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    ImGui::TextDisabled("%zu nodes in %.2f ms; drag to turn, wheel to zoom", nodes.outputs.size(),
                        took.count());
}

} // namespace preview::panels
