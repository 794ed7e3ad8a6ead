// Learning a look from pairs of pictures, and what is known of it then.
#pragma once

#include "converter/match_pairs.h"
#include "lutlib/match/match_look.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/paint/on_picture.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace converter {

/// What the look makes of a pair.
struct MatchedPair {
    PairPaths paths;
    std::vector<std::string> remarks;
    lutlib::ErrorStats delta_e_2000;
    std::vector<std::string> edits;   ///< that the look does not hold, a sentence each
    std::vector<lutlib::Area> parts;  ///< of the pictures, that were edited by themselves
    lutlib::PictureSize size, places; ///< of the pictures, and of the map of them
    std::vector<double> map;          ///< mean dE2000 of each place; NaN where there is nothing
};

struct Matched {
    lutlib::Match match;
    lutlib::LookEncodings look;
    int bits = 0;             ///< of a sample after the grade; 0: floats
    std::size_t pixels = 0;   ///< learnt from
    std::size_t left_out = 0; ///< in places that were edited by themselves
    /// dE2000 of the look, as a file of so many bits holds it: of all pixels, and of a part that
    /// the look which was measured was not learnt from; none where the pictures are too small.
    lutlib::ErrorStats own;
    std::optional<lutlib::ErrorStats> held_out;
    lutlib::ErrorStats rounding; ///< what such a file alone costs, on the held out part
    std::vector<MatchedPair> pairs;
};

/// Throws Error.
Matched match_pairs(std::span<const PairPaths> paths, const PairEncodings& encodings, int size);

} // namespace converter
