#include "preview/panels/parameter_control.h"

#include "preview/panels/tip.h"

#include <fmt/format.h>
#include <imgui.h>

namespace preview::panels {

std::string usual_text(const lutlib::Parameter& parameter, const lutlib::OpContext& context) {
    const std::string unit = parameter.unit.empty() ? "" : " " + std::string(parameter.unit);
    switch (parameter.kind) {
    case lutlib::ParameterKind::number: {
        const double usual = number_of(parameter, default_value(parameter), context);
        return fmt::format("{:.5g}{}{}", usual, unit,
                           parameter.automatic != nullptr
                               ? " (" + std::string(parameter.automatic_words) + ")"
                               : "");
    }
    case lutlib::ParameterKind::toggle:
        return parameter.fallback != 0 ? "on" : "off";
    case lutlib::ParameterKind::rgb: {
        const auto usual = std::get<lutlib::RgbD>(default_value(parameter));
        return fmt::format("{:.5g} {:.5g} {:.5g}{}", usual.r, usual.g, usual.b, unit);
    }
    case lutlib::ParameterKind::curve:
        break;
    }
    return parameter.axis.diagonal ? "the output is the input"
                                   : fmt::format("{:.5g}{}", parameter.fallback, unit);
}

bool parameter_control(Ui& ui, const lutlib::Parameter& parameter, lutlib::Value& value,
                       const std::string& place, const lutlib::OpContext& context) {
    const std::string name(parameter.label);
    const std::string with_unit =
        parameter.unit.empty() ? name : name + " (" + std::string(parameter.unit) + ")";
    // The tip has the unit too, where there is no room for it.
    const float room = ImGui::GetContentRegionAvail().x * 0.45F - em(0.5F);
    const std::string& label = ImGui::CalcTextSize(with_unit.c_str()).x < room ? with_unit : name;
    bool changed = false;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.55F);
    switch (parameter.kind) {
    case lutlib::ParameterKind::number: {
        double number = number_of(parameter, value, context);
        changed = ImGui::SliderScalar(label.c_str(), ImGuiDataType_Double, &number, &parameter.min,
                                      &parameter.max, "%.5g", ImGuiSliderFlags_AlwaysClamp);
        if (changed) {
            value = number;
        }
        break;
    }
    case lutlib::ParameterKind::toggle: {
        bool on = std::get<double>(value) != 0;
        changed = ImGui::Checkbox(label.c_str(), &on);
        value = on ? 1.0 : 0.0;
        break;
    }
    case lutlib::ParameterKind::rgb: {
        const lutlib::RgbD color = std::get<lutlib::RgbD>(value);
        double channels[3] = {color.r, color.g, color.b};
        const auto speed = static_cast<float>((parameter.max - parameter.min) / 1000);
        changed = ImGui::DragScalarN(label.c_str(), ImGuiDataType_Double, channels, 3, speed,
                                     &parameter.min, &parameter.max, "%.5g",
                                     ImGuiSliderFlags_AlwaysClamp);
        value = lutlib::RgbD{channels[0], channels[1], channels[2]};
        break;
    }
    case lutlib::ParameterKind::curve:
        return false; // see curve_editor.h
    }
    mark(ui, place);
    tip({}, usual_text(parameter, context), parameter.kind != lutlib::ParameterKind::toggle);
    return changed;
}

} // namespace preview::panels
