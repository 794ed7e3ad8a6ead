// The instruments on which colourists read levels and gamut, as a table: what each counts over the
// finished picture, in 8-bit codes.
//
// Luma, Cb and Cr are those of Rec. ITU-R BT.709-6, section 3, on full-range codes, in
// fixed point so that the GPU and its twin agree on every count:
//     Y' = .2126 R' + .7152 G' + .0722 B'   Cb = (B' - Y') / 1.8556   Cr = (R' - Y') / 1.5748
// On the vectorscope Cb runs to the right and Cr upwards. Its skin line is NTSC's +I axis, near
// which skin of every shade lies: 33 degrees beyond the axis of R' - Y' (SMPTE 170M-2004: I and Q
// are the colour differences turned by 33 degrees), so at 123 degrees from that of B' - Y', where
// vectorscopes draw it over Cb and Cr as they did over the analogue signal's. Its targets are the
// bars of 75 %.
#pragma once

#include "lutlib/named.h"
#include "preview/finish/scope_area.h"
#include "preview/finish/scope_levels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace preview {

/// What a scope sorts the picture by; the shape of its counts.
enum class ScopeBins : std::uint8_t {
    columns, ///< counts[plane][column][level], of planes x columns x 256
    chroma,  ///< counts[cr][cb], of 256 x 256, neutral at 128, 128
    levels,  ///< counts[plane][level], of red, green, blue, luma
};

struct Scope {
    std::string_view name;
    std::string_view label;
    std::string_view help;
    ScopeBins bins;
    std::uint32_t planes;        ///< of ScopeBins::columns: luma, or red, green and blue
    std::uint32_t width, height; ///< of its picture, unless another size is asked for
    bool logarithmic;            ///< how its counts are drawn, unless the other is asked for
    bool is_overlaid = false;    ///< planes of columns lie over each other, not side by side
};

inline constexpr std::uint32_t scope_levels = 256;

inline constexpr std::array<Scope, 5> scopes{{
    {"waveform", "Waveform", "luma over each column of the picture", ScopeBins::columns, 1, 1024,
     512, true},
    {"parade", "RGB parade", "red, green and blue over each column, side by side",
     ScopeBins::columns, 3, 1024, 512, true},
    {"rgb", "RGB waveform", "red, green and blue over each column, one over the other",
     ScopeBins::columns, 3, 1024, 512, true, true},
    {"vectorscope", "Vectorscope", "hue and saturation, with 75 % targets and the skin line",
     ScopeBins::chroma, 1, 640, 640, true},
    {"histogram", "Histogram", "how often each code occurs in red, green, blue and luma",
     ScopeBins::levels, 4, 768, 384, false},
}};

constexpr bool has_levels(const Scope& scope) {
    return scope.bins != ScopeBins::chroma;
}

/// The place of a row in `scopes`, and so of what is kept for each of them.
constexpr std::size_t index_of(const Scope& scope) {
    return static_cast<std::size_t>(&scope - scopes.data());
}

/// How many counts a scope keeps. `columns` counts only for ScopeBins::columns.
constexpr std::size_t scope_counts(const Scope& scope, std::uint32_t columns) {
    switch (scope.bins) {
    case ScopeBins::columns:
        return std::size_t{scope.planes} * columns * scope_levels;
    case ScopeBins::chroma:
        return std::size_t{scope_levels} * scope_levels;
    case ScopeBins::levels:
        break;
    }
    return std::size_t{scope.planes} * scope_levels;
}

/// How counts become brightness or height.
struct ScopeScale {
    std::string_view name;
    std::string_view label;
    std::optional<bool> logarithmic; ///< empty: as the scope's row says
};
inline constexpr std::array<ScopeScale, 3> scope_scales{{
    {"own", "each scope's own", std::nullopt},
    {"log", "by the logarithm of the counts", true},
    {"linear", "in proportion to the counts", false},
}};

/// How often counts are multiplied before they become brightness or height.
struct ScopeGain {
    std::string_view name;
    std::string_view label;
    float factor;
};
inline constexpr std::array<ScopeGain, 7> scope_gains{{
    {"x0.25", "-12 dB, a quarter", 0.25F},
    {"x0.5", "-6 dB, half", 0.5F},
    {"x1", "0 dB, as they are", 1},
    {"x2", "+6 dB, twice", 2},
    {"x4", "+12 dB, four times", 4},
    {"x8", "+18 dB, eight times", 8},
    {"x16", "+24 dB, sixteen times", 16},
}};
inline constexpr const ScopeGain& scope_gain_none = lutlib::row_named(scope_gains, "x1");

/// How much room a character of a scope's figures takes, in pixels.
struct FigureSize {
    std::int32_t advance = 0, height = 0;
    friend bool operator==(const FigureSize&, const FigureSize&) = default;
};

/// Where the counts stand in a scope's picture, in its pixels from the upper left; one plot for
/// each plane of ScopeBins::columns, else one.
struct ScopePlot {
    std::int32_t x = 0, y = 0, width = 1, height = 1; ///< of the first plot
    std::int32_t stride = 0;                          ///< from one plot to the next
    std::int32_t dot = 1; ///< of figures that the picture has itself, 6 dots apart and 6 high
};
/// With room for `levels` in figures of that size, else in those made of dots.
ScopePlot scope_plot(const Scope& scope, std::uint32_t width, std::uint32_t height,
                     std::optional<FigureSize> figures = std::nullopt,
                     std::span<const LevelFigure> levels = percent_figures());

/// What is written beside a plot: levels, or the names of the 75 % bars and the skin line.
struct ScopeLabel {
    std::string text;
    std::int32_t x = 0, y = 0; ///< of its upper left corner, in pixels of the scope's picture
};
std::vector<ScopeLabel> scope_labels(const Scope& scope, const ScopePlot& plot, FigureSize figures,
                                     std::span<const LevelFigure> levels = percent_figures());
/// Of figures made of dots.
constexpr FigureSize dotted_figures(const ScopePlot& plot) {
    return {6 * plot.dot, 6 * plot.dot};
}

} // namespace preview
