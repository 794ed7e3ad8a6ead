// The colours of panels and text: neutral greys, for nothing coloured may stand beside a picture
// that is being graded (ISO 3664:2009 asks for a neutral, dark surround). Colour is left to what it
// means.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace preview::panels {

/// A grey, as a code of sRGB.
struct ThemeGrey {
    int slot; ///< one of ImGuiCol
    std::uint8_t code = 0;
    std::uint8_t opacity = 255;
};
std::span<const ThemeGrey> theme_greys();

/// What is to be told from what: WCAG 2.1 asks for a contrast of 4.5 of text (1.4.3), of 3 of parts
/// of controls (1.4.11).
struct ThemePair {
    int front, back; ///< of ImGuiCol
    double least;
};
std::span<const ThemePair> theme_pairs();

/// Of messages that ask for somebody, over windows.
inline constexpr std::array<std::uint8_t, 3> warning_color{255, 190, 60};

/// WCAG's: 1 for the same, 21 for black on white. Of codes of sRGB.
double contrast_of(std::array<std::uint8_t, 3> a, std::array<std::uint8_t, 3> b);

/// How many colours the style has, what one is called, and those that windows are filled with.
int slot_count();
std::string_view name_of_slot(int slot);
std::span<const int> window_slots();

/// Sets the colours of Dear ImGui's style.
void apply_theme();

} // namespace preview::panels
