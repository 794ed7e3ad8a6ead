// What the levels of waveforms, parades and histograms stand for: the codes as they are shown, or
// the same colours in another encoding, rounded to 8-bit codes of it.
//
// Light of 1 is diffuse white, which is the display's white. Where it is so many cd/m2 counts for
// PQ alone, whose codes are luminances. Linear light ends at the brightest that the shown codes
// stand for.
#pragma once

#include "lutlib/color/encoding.h"
#include "preview/finish/compare.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace preview {

struct ScopeSide;

/// cd/m2, until a person names another.
inline constexpr float usual_display_white = 100;
inline constexpr double least_display_white = 48, most_display_white = 1000;

struct ScopeLevels {
    std::optional<lutlib::Encoding> encoding; ///< empty: the codes as they are shown
    lutlib::Encoding shown = lutlib::srgb();  ///< what those are
    float white = usual_display_white;        ///< of the display, in cd/m2

    /// Whether the levels are other codes than the shown ones.
    bool converts() const { return encoding && *encoding != shown; }
    friend bool operator==(const ScopeLevels&, const ScopeLevels&) = default;
};

/// What light of the shown codes is multiplied with before it is encoded, and which code of the
/// encoding is the uppermost level.
struct LevelScale {
    double factor = 1, top = 1;
};
LevelScale level_scale(const ScopeLevels& levels);

/// A figure beside a plot, and at which share of its height it stands.
struct LevelFigure {
    std::string text;
    double at = 0;
};
/// From the lowest: luminances of PQ, multiples of diffuse white of linear light, else per cent.
std::vector<LevelFigure> level_figures(const ScopeLevels& levels);
/// Of codes as they are shown.
const std::vector<LevelFigure>& percent_figures();

/// What a share of the height stands for, in the unit of the figures.
double level_value(const ScopeLevels& levels, double share);
std::string_view level_unit(const ScopeLevels& levels);

/// "levels are pq/rec2020 of the shown srgb, white at 100 cd/m2".
std::string levels_text(const ScopeLevels& levels);

/// What the codes of that side are, where those of A and B are these; empty where it is made of
/// both and they differ.
std::optional<lutlib::Encoding> shown_codes(const ScopeSide& side, const Compare& compare,
                                            const std::array<lutlib::Encoding, 2>& sides);

/// What a person must know then.
std::string mixed_codes_text(const std::array<lutlib::Encoding, 2>& sides);

} // namespace preview
