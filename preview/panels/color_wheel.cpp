#include "preview/panels/color_wheel.h"

#include "preview/editor/wheel.h"
#include "preview/panels/parameter_control.h"
#include "preview/panels/tip.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace preview::panels {

namespace {

using lutlib::Parameter;
using lutlib::RgbD;

constexpr double pi = std::numbers::pi;
constexpr double ring_reach = pi * 5 / 6;  // from the top to either end
constexpr float rim = 0.76F, ring = 0.88F; // of half the side: the wheel's, the ring's middle
constexpr float fine = 0.1F;               // with Shift

struct Dial {
    ImVec2 middle;
    float half = 1;

    ImVec2 at(double x, double y, float radius) const {
        return {middle.x + half * radius * static_cast<float>(x),
                middle.y - half * radius * static_cast<float>(y)};
    }
    /// `turn` of the ring, clockwise from the top.
    ImVec2 on_ring(double turn) const {
        const double angle = std::clamp(turn, -1.0, 1.0) * ring_reach;
        return at(std::sin(angle), std::cos(angle), ring);
    }
    float distance(ImVec2 place) const {
        return std::hypot(place.x - middle.x, place.y - middle.y) / half;
    }
    double clockwise(ImVec2 place) const {
        return std::atan2(place.x - middle.x, middle.y - place.y);
    }
};

ImU32 shown(RgbD codes, int opacity) {
    const auto code = [](double x) { return static_cast<int>(std::lround(255 * x)); };
    return IM_COL32(code(codes.r), code(codes.g), code(codes.b), opacity);
}

void draw(const Dial& dial, const WheelPlace& place, bool is_lit) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    constexpr int steps = 48;
    list.AddCircleFilled(dial.middle, dial.half * rim, IM_COL32(30, 30, 30, 255), steps);
    for (int i = 0; i < steps; ++i) {
        const double from = 2 * pi * i / steps, to = 2 * pi * (i + 1) / steps;
        list.AddLine(dial.at(std::cos(from), std::sin(from), rim),
                     dial.at(std::cos(to), std::sin(to), rim),
                     shown(wheel_color((from + to) / 2), 255), em(0.2F));
    }
    const ImU32 faint = IM_COL32(255, 255, 255, 40);
    list.AddLine(dial.at(-1, 0, rim), dial.at(1, 0, rim), faint);
    list.AddLine(dial.at(0, -1, rim), dial.at(0, 1, rim), faint);
    constexpr auto quarter = static_cast<float>(pi / 2), reach = static_cast<float>(ring_reach);
    list.PathArcTo(dial.middle, dial.half * ring, -quarter - reach, -quarter + reach, steps);
    list.PathStroke(IM_COL32(110, 110, 110, 255), 0, em(0.14F));
    list.AddLine(dial.at(0, 1, ring - 0.05F), dial.at(0, 1, ring + 0.05F),
                 IM_COL32(170, 170, 170, 255));
    const ImU32 handle = is_lit ? IM_COL32(255, 190, 60, 255) : IM_COL32(235, 235, 235, 255);
    list.AddCircleFilled(dial.on_ring(place.turn), em(0.3F), handle);
    const double away = std::max(std::hypot(place.x, place.y), 1.0);
    const ImVec2 point = dial.at(place.x / away, place.y / away, rim);
    list.AddLine(dial.middle, point, IM_COL32(200, 200, 200, 120));
    list.AddCircleFilled(point, em(0.32F), IM_COL32(20, 20, 20, 255));
    list.AddCircle(point, em(0.32F), handle, 0, em(0.12F));
}

/// What the mouse does to the place; the item is the wheel's.
bool drag(const Dial& dial, WheelPlace& place) {
    static bool is_ring = false; // one mouse, one drag
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActivated()) {
        is_ring = dial.distance(io.MousePos) > (rim + ring) / 2;
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        const WheelPlace before = place;
        if (is_ring) {
            place.turn = 0;
        } else {
            place.x = place.y = 0;
        }
        return before.turn != place.turn || before.x != place.x || before.y != place.y;
    }
    const ImVec2 by = io.MouseDelta;
    if (!ImGui::IsItemActive() || (by.x == 0 && by.y == 0)) {
        return false;
    }
    const double share = io.KeyShift ? fine : 1;
    if (is_ring) {
        const ImVec2 before{io.MousePos.x - by.x, io.MousePos.y - by.y};
        const double turned = dial.clockwise(io.MousePos) - dial.clockwise(before);
        place.turn =
            std::clamp(place.turn + share * std::remainder(turned, 2 * pi) / ring_reach, -1.0, 1.0);
    } else {
        const double radius = static_cast<double>(dial.half * rim);
        place.x += share * static_cast<double>(by.x) / radius;
        place.y -= share * static_cast<double>(by.y) / radius;
        const double away = std::hypot(place.x, place.y);
        place.x /= std::max(away, 1.0);
        place.y /= std::max(away, 1.0);
    }
    return true;
}

/// No more digits than a hand can tell apart.
RgbD rounded(const Parameter& parameter, RgbD value) {
    constexpr double steps = 1e4;
    for (std::size_t i = 0; i < 3; ++i) {
        value[i] = std::clamp(std::round(value[i] * steps) / steps, parameter.min, parameter.max);
    }
    return value;
}

bool number(Ui& ui, const char* name, double& value, const Parameter& parameter,
            const std::string& place, float width, const std::string& help) {
    ImGui::SetNextItemWidth(width);
    const auto speed =
        static_cast<float>(std::max(parameter.wheel.brightness, parameter.wheel.balance) / 300);
    const std::string format = std::string(name) + " %.3f";
    ImGui::PushID(name);
    const bool changed =
        ImGui::DragScalar("", ImGuiDataType_Double, &value, speed, &parameter.min, &parameter.max,
                          format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopID();
    mark(ui, place);
    tip(help, usual_text(parameter), true);
    return changed;
}

/// Luma and the channels, in two rows.
bool numbers(Ui& ui, const Parameter& parameter, RgbD& value, const std::string& place,
             float width) {
    constexpr std::array<const char*, 3> names{"R", "G", "B"};
    constexpr std::array<const char*, 3> marks{".r", ".g", ".b"};
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, half = (width - gap) / 2;
    WheelPlace at = wheel_place(parameter, value);
    const double sign = parameter.wheel.is_inverted ? -1 : 1;
    const double usual = parameter.fallback_rgb.r;
    double luma = usual + sign * at.turn * parameter.wheel.brightness;
    bool changed = false;
    if (number(ui, "Y", luma, parameter, place + ".y", half, "all channels, by their luma")) {
        at.turn = sign * (luma - usual) / parameter.wheel.brightness;
        value = rounded(parameter, value_on_wheel(parameter, at));
        changed = true;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (i != 1) {
            ImGui::SameLine(0, gap);
        }
        changed |= number(ui, names[i], value[i], parameter, place + marks[i], half, {});
    }
    return changed;
}

} // namespace

bool color_wheel(Ui& ui, const Parameter& parameter, RgbD& value, const std::string& place,
                 float width) {
    ImGui::BeginGroup();
    ImGui::PushID(place.c_str());
    ImGui::AlignTextToFramePadding(); // as what stands beside fields, in every row
    ImGui::TextUnformatted(std::string(parameter.label).c_str());
    ImGui::InvisibleButton("wheel", {width, width});
    mark(ui, place);
    const ImVec2 low = ImGui::GetItemRectMin();
    const Dial dial{{low.x + width / 2, low.y + width / 2}, width / 2};
    WheelPlace at = wheel_place(parameter, value);
    bool changed = drag(dial, at);
    if (changed) {
        value = rounded(parameter, value_on_wheel(parameter, at));
    }
    draw(dial, wheel_place(parameter, value), ImGui::IsItemActive());
    if (!ImGui::IsItemActive()) {
        tip("Drag towards a colour, or the ring to the right for more; Shift is finer, a double "
            "click brings back the default",
            usual_text(parameter), false);
    }
    changed |= numbers(ui, parameter, value, place, width);
    ImGui::PopID();
    ImGui::EndGroup();
    return changed;
}

bool color_wheels(Ui& ui, std::span<const Parameter> parameters, std::span<lutlib::Value> values,
                  const std::string& place) {
    const auto has_wheel = [](const Parameter& row) { return row.wheel.balance > 0; };
    const auto count = std::count_if(parameters.begin(), parameters.end(), has_wheel);
    if (count == 0) {
        return false;
    }
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x;
    const auto beside = static_cast<float>(std::min<std::ptrdiff_t>(
        count, std::max(1, static_cast<int>((room + gap) / (em(7.5F) + gap)))));
    const float width = std::min((room - gap * (beside - 1)) / beside, em(12));
    bool changed = false;
    float drawn = 0;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (!has_wheel(parameters[i])) {
            continue;
        }
        if (drawn > 0 && std::fmod(drawn, beside) > 0) {
            ImGui::SameLine();
        }
        drawn += 1;
        changed |= color_wheel(ui, parameters[i], std::get<RgbD>(values[i]),
                               place + "." + std::string(parameters[i].name), width);
    }
    return changed;
}

} // namespace preview::panels
