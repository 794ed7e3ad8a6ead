// The look that made one picture of another, learnt from their pixels.
//
// A base look (base_look.h) is fitted to the means of like colours, and a lattice to what it leaves
// over (residual_lattice.h). Pixels that do not follow the others of their colour, and colours that
// do not follow those around them, count little.
#pragma once

#include "lutlib/lut.h"
#include "lutlib/match/base_look.h"
#include "lutlib/match/color_bins.h"

#include <array>
#include <vector>

namespace lutlib {

struct MatchSettings {
    int size = 33; ///< nodes a side
    int bits = 8;  ///< of a sample after the grade; 0: floats
};

struct Match {
    Lut3D cube; ///< over 0..1; nodes may lie outside of it
    BaseLook base;
    /// Of each node, about how many pixels say so, up to a bound for those of one colour.
    std::vector<double> support;
    RgbD smoothness;  ///< of each channel's lattice (residual_lattice.h)
    double noise = 0; ///< standard deviation of a channel about the look, 0..1
    /// Channels that fall somewhere along the greys, as the pixels themselves do.
    std::array<bool, 3> greys_fall{};
};

/// Along the greys, what no pixel says rises as the base does. `start`, learnt from most of these
/// pixels, saves two thirds of the time; it may have another size. Throws Error where no pixel is
/// finite, and for a size outside limits.h.
Match match_look(std::vector<PixelPair> pixels, const MatchSettings& settings = {},
                 const Match* start = nullptr);

} // namespace lutlib
