// Reference colours: what a grade is judged by.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace lutlib {

struct Swatch {
    std::string_view name;
    std::array<std::uint8_t, 3> srgb; ///< display-encoded code values
};

/// The 24 patches of the ColorChecker chart, rows from the top, in the sRGB (D65) code values that
/// the maker publishes: X-Rite, "Colorimetric values for ColorChecker family of targets".
inline constexpr std::array<Swatch, 24> color_checker{{
    {"dark skin", {115, 82, 68}},     {"light skin", {194, 150, 130}},
    {"blue sky", {98, 122, 157}},     {"foliage", {87, 108, 67}},
    {"blue flower", {133, 128, 177}}, {"bluish green", {103, 189, 170}},
    {"orange", {214, 126, 44}},       {"purplish blue", {80, 91, 166}},
    {"moderate red", {193, 90, 99}},  {"purple", {94, 60, 108}},
    {"yellow green", {157, 188, 64}}, {"orange yellow", {224, 163, 46}},
    {"blue", {56, 61, 150}},          {"green", {70, 148, 73}},
    {"red", {175, 54, 60}},           {"yellow", {231, 199, 31}},
    {"magenta", {187, 86, 149}},      {"cyan", {8, 133, 161}},
    {"white 9.5", {243, 243, 242}},   {"neutral 8", {200, 200, 200}},
    {"neutral 6.5", {160, 160, 160}}, {"neutral 5", {122, 122, 121}},
    {"neutral 3.5", {85, 85, 85}},    {"black 2", {52, 52, 52}},
}};

/// Skin from light to dark: the ten tones of the Monk Skin Tone Scale (Ellis Monk, 2022).
inline constexpr std::array<Swatch, 10> skin_tones{{
    {"skin 1", {246, 237, 228}},
    {"skin 2", {243, 231, 219}},
    {"skin 3", {247, 234, 208}},
    {"skin 4", {234, 218, 186}},
    {"skin 5", {215, 189, 150}},
    {"skin 6", {160, 126, 86}},
    {"skin 7", {130, 92, 67}},
    {"skin 8", {96, 65, 52}},
    {"skin 9", {58, 49, 42}},
    {"skin 10", {41, 36, 32}},
}};

/// A reflectance in CIELAB 1976 under D65.
struct LabSwatch {
    std::string_view name;
    std::array<double, 3> lab;
};

/// Means of measured skin, from dark to light: Xiao et al. 2017, "Characterising the variations in
/// ethnic skin colours: a new calibrated data base for human skin", Skin Research and Technology
/// 23(1), of 187 Caucasian, 202 Chinese, 145 Kurdish and 426 Thai people. One standard deviation of
/// L* is 3 to 5.5.
inline constexpr std::array<LabSwatch, 12> measured_skins{{
    {"Kurdish forehead", {56.1, 11.3, 16.4}},
    {"Chinese forehead", {56.4, 11.7, 16.3}},
    {"Thai forehead", {56.8, 11.6, 17.7}},
    {"Kurdish cheek", {58.0, 11.7, 15.8}},
    {"Chinese cheek", {58.9, 11.4, 14.2}},
    {"Caucasian forehead", {59.2, 11.6, 15.1}},
    {"Caucasian cheek", {59.6, 11.8, 14.6}},
    {"Kurdish inner arm", {60.6, 6.5, 16.4}},
    {"Thai cheek", {60.7, 10.5, 17.2}},
    {"Chinese inner arm", {60.9, 7.0, 15.0}},
    {"Thai inner arm", {61.9, 7.1, 17.4}},
    {"Caucasian inner arm", {63.0, 5.6, 14.0}},
}};

} // namespace lutlib
