// How a person has the panel Look: what is open and chosen in it. None of it is of the look, and
// undo leaves it as it is.
#pragma once

#include "lutlib/recipe/color_correction.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace preview::panels {

/// Of one plot of curves.
struct CurveUse {
    std::size_t edited = 0;          ///< which of the operator's curves the mouse changes
    std::vector<bool> hidden;        ///< of the others; shorter: the rest is seen
    std::optional<std::size_t> knot; ///< the one whose numbers are shown
    std::string typed;               ///< all knots as text
    bool is_typing = false;
    std::string problem; ///< with those that were typed last
};

/// Of files of ASC CDL corrections.
struct CdlUse {
    std::string path;                                 ///< opened last; empty: none
    std::vector<lutlib::ColorCorrection> corrections; ///< of it
    std::size_t chosen = 0;                           ///< among them
    std::string id;                                   ///< under which the next one is saved
    std::string report; ///< what was opened, and what of it the operator does not hold
};

struct LookUse {
    std::size_t page = 0;
    std::vector<bool> open;             ///< operators whose controls are seen, by their places
    std::optional<std::size_t> chosen;  ///< the operator that keys are for
    std::optional<std::size_t> dragged; ///< the operator whose heading the mouse holds
    std::map<std::string, CurveUse> curves;
    bool one_plot = true; ///< of a page whose curves lie over one axis
    CdlUse cdl;
};

} // namespace preview::panels
