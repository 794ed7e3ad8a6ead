#include "preview/panels/look_parts.h"
#include "preview/panels/operator_controls.h"
#include "preview/panels/tip.h"

#include <imgui.h>

#include <algorithm>
#include <array>

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
    {"CDL", "slope, offset, power and saturation of an ASC CDL", cdl_ops},
    {"Curves", "tone curves of all channels and of each", curve_ops},
    {"Hues", "hue, saturation and luminance over hue", hue_ops},
    {"Range", "what qualifiers of hue, saturation and luminance choose", range_ops},
}};

} // namespace

std::span<const LookPage> look_pages() {
    return pages;
}

void page_of_operators(Ui& ui, const LookPage& page) {
    for (const std::string_view name : page.ops) {
        lutlib::Recipe& recipe = ui.history.draft().recipe;
        const lutlib::Op& op = *lutlib::op_named(name);
        const auto found =
            std::find_if(recipe.operations.begin(), recipe.operations.end(),
                         [&](const Operation& operation) { return operation.op == &op; });
        const auto at = static_cast<std::size_t>(found - recipe.operations.begin());
        const bool is_there = found != recipe.operations.end();
        Operation operation = is_there ? *found : default_operation(op);
        const std::string place = "page." + std::string(name);
        ImGui::PushID(place.c_str());
        bool changed = false;
        ImGui::BeginDisabled(!is_there);
        changed |= ImGui::Checkbox(std::string(op.label).c_str(), &operation.enabled);
        ImGui::EndDisabled();
        mark(ui, place + ".on");
        tip(op.help, "on", false);
        changed |= operator_controls(ui, operation, at, place);
        if (is_there && ImGui::Button("Reset")) {
            operation.values = default_operation(op).values;
            changed = true;
        }
        if (is_there) {
            mark(ui, place + ".reset");
            ui.look.chosen = changed ? at : ui.look.chosen;
        }
        if (changed && is_there) {
            recipe.operations[at] = std::move(operation);
        } else if (changed) {
            recipe.operations.push_back(std::move(operation));
            ui.look.chosen = at;
        }
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
