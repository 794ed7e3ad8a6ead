#include "preview/panels/curve_editor.h"
#include "preview/panels/look_parts.h"
#include "preview/panels/operator_controls.h"
#include "preview/panels/tip.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace preview::panels {

namespace {

using lutlib::Operation;

constexpr std::array<std::string_view, 2> wheel_ops{"lift-gamma-gain", "offset"};
constexpr std::array<std::string_view, 1> cdl_ops{"cdl"};
constexpr std::array<std::string_view, 1> curve_ops{"curves"};
constexpr std::array<std::string_view, 3> hue_ops{"hue-vs-hue", "hue-vs-sat", "hue-vs-lum"};
constexpr std::array<std::string_view, 1> range_ops{"hue-range"};

constexpr std::array<LookPage, 6> pages{{
    {"Operators", "all operators of the look, in their order", {}},
    {"Wheels", "lift, gamma, gain and offset", wheel_ops},
    {"CDL", "slope, offset, power and saturation of an ASC CDL, and its files", cdl_ops,
     &cdl_files},
    {"Curves", "tone curves of all channels and of each", curve_ops},
    {"Hues", "hue, saturation and luminance over hue", hue_ops, nullptr, true},
    {"Range", "what qualifiers of hue, saturation and luminance choose", range_ops},
}};

/// An operator of a page: the recipe's first of its kind, or one that is not there yet.
struct PageOperator {
    PageOperator(const lutlib::Recipe& recipe, std::string_view name)
        : op(*lutlib::op_named(name)), operation(default_operation(op)) {
        const auto found = std::find_if(recipe.operations.begin(), recipe.operations.end(),
                                        [&](const Operation& row) { return row.op == &op; });
        at = static_cast<std::size_t>(found - recipe.operations.begin());
        is_there = found != recipe.operations.end();
        operation = is_there ? *found : operation;
    }
    const lutlib::Op& op;
    std::size_t at = 0;
    bool is_there = false;
    Operation operation;
};

/// Whether it is taken; its heading.
bool enabled_box(Ui& ui, PageOperator& row, const std::string& place) {
    ImGui::BeginDisabled(!row.is_there);
    const bool changed = ImGui::Checkbox(std::string(row.op.label).c_str(), &row.operation.enabled);
    ImGui::EndDisabled();
    mark(ui, place + ".on");
    tip(row.op.help, "on", false);
    return changed;
}

bool reset_button(Ui& ui, PageOperator& row, const std::string& place) {
    if (!row.is_there) {
        return false;
    }
    const bool pressed = ImGui::Button("Reset");
    mark(ui, place + ".reset");
    if (pressed) {
        row.operation.values = default_operation(row.op).values;
    }
    return pressed;
}

/// Into the recipe, where it was changed.
void put_back(Ui& ui, PageOperator&& row, bool changed) {
    auto& operations = ui.history.draft().recipe.operations;
    if (!changed) {
        return;
    }
    ui.look.chosen = row.at;
    if (row.is_there) {
        operations[row.at] = std::move(row.operation);
    } else {
        operations.push_back(std::move(row.operation));
    }
}

/// The curves of all operators in one plot; switch and reset are those of the one that is edited.
void curves_in_one_plot(Ui& ui, const LookPage& page) {
    const lutlib::Recipe& recipe = ui.history.draft().recipe;
    const std::string plot = "page." + std::string(page.name);
    std::vector<PageOperator> rows;
    std::vector<lutlib::Parameter> curves;
    std::vector<lutlib::Value> values;
    for (const std::string_view name : page.ops) {
        PageOperator& row = rows.emplace_back(recipe, name);
        curves.push_back(row.op.parameters.front());
        curves.back().name = row.op.name; // each operator calls its own "curve"
        values.push_back(row.operation.values.front());
    }
    bool changed = curve_editor(ui, curves, values, plot, [&](std::size_t i) {
        start_picking_knot(ui, rows[i].op, rows[i].at, 0, plot);
    });
    const std::size_t edited = ui.look.curves[plot].edited;
    PageOperator& row = rows[edited];
    row.operation.values.front() = std::move(values[edited]);
    const std::string place = "page." + std::string(row.op.name);
    changed |= enabled_box(ui, row, place);
    ImGui::SameLine();
    changed |= reset_button(ui, row, place);
    put_back(ui, std::move(row), changed);
}

} // namespace

std::span<const LookPage> look_pages() {
    return pages;
}

void page_of_operators(Ui& ui, const LookPage& page) {
    if (page.above != nullptr) {
        page.above(ui);
    }
    if (page.is_over_one_axis) {
        ImGui::Checkbox("In one plot", &ui.look.one_plot);
        mark(ui, "page.one-plot");
        tip("All curves in one plot, or each in its own", "on", false);
        if (ui.look.one_plot) {
            curves_in_one_plot(ui, page);
            return;
        }
    }
    for (const std::string_view name : page.ops) {
        PageOperator row(ui.history.draft().recipe, name);
        const std::string place = "page." + std::string(name);
        ImGui::PushID(place.c_str());
        bool changed = enabled_box(ui, row, place);
        changed |= operator_controls(ui, row.operation, row.at, place);
        changed |= reset_button(ui, row, place);
        put_back(ui, std::move(row), changed);
        ImGui::Separator();
        ImGui::PopID();
    }
}

void opacity_control(Ui& ui, const char* label, const char* help, double& opacity,
                     const std::string& place) {
    constexpr double least = 0, most = 100;
    double percent = 100 * opacity;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.55F);
    if (ImGui::SliderScalar(label, ImGuiDataType_Double, &percent, &least, &most, "%.4g %%",
                            ImGuiSliderFlags_AlwaysClamp)) {
        opacity = percent / 100;
    }
    mark(ui, place);
    tip(help, "100 %", true);
}

} // namespace preview::panels
