#include "preview/panels/theme.h"

#include "lutlib/color/transfer.h"

#include <imgui.h>

#include <algorithm>

namespace preview::panels {

namespace {

constexpr ThemeGrey greys[] = {
    {ImGuiCol_Text, 230},
    {ImGuiCol_TextDisabled, 165},
    {ImGuiCol_TextSelectedBg, 95},
    {ImGuiCol_WindowBg, 38},
    {ImGuiCol_ChildBg, 38, 0},
    {ImGuiCol_PopupBg, 32},
    {ImGuiCol_Border, 118},
    {ImGuiCol_BorderShadow, 0, 0},
    {ImGuiCol_FrameBg, 54},
    {ImGuiCol_FrameBgHovered, 66},
    {ImGuiCol_FrameBgActive, 76},
    {ImGuiCol_TitleBg, 30},
    {ImGuiCol_TitleBgActive, 46},
    {ImGuiCol_TitleBgCollapsed, 30},
    {ImGuiCol_MenuBarBg, 46},
    {ImGuiCol_ScrollbarBg, 38},
    {ImGuiCol_ScrollbarGrab, 122},
    {ImGuiCol_ScrollbarGrabHovered, 150},
    {ImGuiCol_ScrollbarGrabActive, 180},
    {ImGuiCol_CheckMark, 235},
    {ImGuiCol_SliderGrab, 150},
    {ImGuiCol_SliderGrabActive, 205},
    {ImGuiCol_Button, 66},
    {ImGuiCol_ButtonHovered, 84},
    {ImGuiCol_ButtonActive, 98},
    {ImGuiCol_Header, 60},
    {ImGuiCol_HeaderHovered, 80},
    {ImGuiCol_HeaderActive, 94},
    {ImGuiCol_Separator, 118},
    {ImGuiCol_SeparatorHovered, 150},
    {ImGuiCol_SeparatorActive, 205},
    {ImGuiCol_ResizeGrip, 118},
    {ImGuiCol_ResizeGripHovered, 150},
    {ImGuiCol_ResizeGripActive, 205},
    {ImGuiCol_Tab, 48},
    {ImGuiCol_TabHovered, 84},
    {ImGuiCol_TabActive, 98},
    {ImGuiCol_TabUnfocused, 48},
    {ImGuiCol_TabUnfocusedActive, 98},
    {ImGuiCol_PlotLines, 180},
    {ImGuiCol_PlotLinesHovered, 230},
    {ImGuiCol_PlotHistogram, 180},
    {ImGuiCol_PlotHistogramHovered, 230},
    {ImGuiCol_TableHeaderBg, 48},
    {ImGuiCol_TableBorderStrong, 90},
    {ImGuiCol_TableBorderLight, 70},
    {ImGuiCol_TableRowBg, 0, 0},
    {ImGuiCol_TableRowBgAlt, 255, 10},
    {ImGuiCol_DragDropTarget, 230},
    {ImGuiCol_NavHighlight, 230},
    {ImGuiCol_NavWindowingHighlight, 230},
    {ImGuiCol_NavWindowingDimBg, 20, 150},
    {ImGuiCol_ModalWindowDimBg, 0, 130},
};

constexpr double of_text = 4.5, of_parts = 3;

constexpr ThemePair pairs[] = {
    {ImGuiCol_Text, ImGuiCol_WindowBg, of_text},
    {ImGuiCol_Text, ImGuiCol_PopupBg, of_text},
    {ImGuiCol_Text, ImGuiCol_TextSelectedBg, of_text},
    {ImGuiCol_Text, ImGuiCol_FrameBg, of_text},
    {ImGuiCol_Text, ImGuiCol_FrameBgHovered, of_text},
    {ImGuiCol_Text, ImGuiCol_FrameBgActive, of_text},
    {ImGuiCol_Text, ImGuiCol_TitleBg, of_text},
    {ImGuiCol_Text, ImGuiCol_TitleBgActive, of_text},
    {ImGuiCol_Text, ImGuiCol_Button, of_text},
    {ImGuiCol_Text, ImGuiCol_ButtonHovered, of_text},
    {ImGuiCol_Text, ImGuiCol_ButtonActive, of_text},
    {ImGuiCol_Text, ImGuiCol_Header, of_text},
    {ImGuiCol_Text, ImGuiCol_HeaderHovered, of_text},
    {ImGuiCol_Text, ImGuiCol_HeaderActive, of_text},
    {ImGuiCol_Text, ImGuiCol_Tab, of_text},
    {ImGuiCol_Text, ImGuiCol_TabHovered, of_text},
    {ImGuiCol_Text, ImGuiCol_TabActive, of_text},
    {ImGuiCol_Text, ImGuiCol_TableHeaderBg, of_text},
    // It tells things too, and not only what cannot be pressed.
    {ImGuiCol_TextDisabled, ImGuiCol_WindowBg, of_text},
    {ImGuiCol_TextDisabled, ImGuiCol_PopupBg, of_text},
    {ImGuiCol_TextDisabled, ImGuiCol_FrameBg, of_text},
    {ImGuiCol_Border, ImGuiCol_WindowBg, of_parts},
    {ImGuiCol_Border, ImGuiCol_PopupBg, of_parts},
    {ImGuiCol_Separator, ImGuiCol_WindowBg, of_parts},
    {ImGuiCol_ScrollbarGrab, ImGuiCol_ScrollbarBg, of_parts},
    {ImGuiCol_ScrollbarGrabHovered, ImGuiCol_ScrollbarBg, of_parts},
    {ImGuiCol_ScrollbarGrabActive, ImGuiCol_ScrollbarBg, of_parts},
    {ImGuiCol_ResizeGrip, ImGuiCol_WindowBg, of_parts},
    {ImGuiCol_CheckMark, ImGuiCol_FrameBg, of_parts},
    {ImGuiCol_CheckMark, ImGuiCol_FrameBgHovered, of_parts},
    {ImGuiCol_CheckMark, ImGuiCol_FrameBgActive, of_parts},
    {ImGuiCol_SliderGrab, ImGuiCol_FrameBg, of_parts},
    {ImGuiCol_SliderGrabActive, ImGuiCol_FrameBgActive, of_parts},
    {ImGuiCol_NavHighlight, ImGuiCol_WindowBg, of_parts},
    {ImGuiCol_TabActive, ImGuiCol_Tab, 1.5}, // its border tells it too
};

double luminance_of(std::array<std::uint8_t, 3> codes) {
    const auto light = [](std::uint8_t code) { return lutlib::srgb_decode(code / 255.0); };
    return 0.2126 * light(codes[0]) + 0.7152 * light(codes[1]) + 0.0722 * light(codes[2]);
}

} // namespace

std::span<const ThemeGrey> theme_greys() {
    return greys;
}

std::span<const ThemePair> theme_pairs() {
    return pairs;
}

double contrast_of(std::array<std::uint8_t, 3> a, std::array<std::uint8_t, 3> b) {
    const double one = luminance_of(a), other = luminance_of(b);
    return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

int slot_count() {
    return ImGuiCol_COUNT;
}

std::string_view name_of_slot(int slot) {
    return ImGui::GetStyleColorName(slot);
}

std::span<const int> window_slots() {
    static constexpr int slots[] = {ImGuiCol_WindowBg, ImGuiCol_PopupBg};
    return slots;
}

void apply_theme() {
    ImGuiStyle& style = ImGui::GetStyle();
    for (const ThemeGrey& row : greys) {
        const float code = static_cast<float>(row.code) / 255;
        style.Colors[row.slot] = {code, code, code, static_cast<float>(row.opacity) / 255};
    }
    style.FrameBorderSize = 1;
}

} // namespace preview::panels
