// Learning a look from pairs of pictures, and what is known of it then.
#pragma once

#include "converter/match_pairs.h"
#include "lutlib/match/coverage.h"
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
    lutlib::Shift shift;
    lutlib::ErrorStats delta_e_2000;
    std::vector<std::string> edits;   ///< that the look does not hold, a sentence each
    std::vector<lutlib::Area> parts;  ///< of the pictures, that were edited by themselves
    lutlib::PictureSize size, places; ///< of the pictures, and of the map of them
    std::vector<double> map;          ///< mean dE2000 of each place; NaN where there is nothing
};

/// A patch of a chart, in codes of the look's encodings.
struct MatchedPatch {
    std::string name;
    lutlib::RgbD before, after;
    double off = 0;          ///< dE2000 of the look there
    double off_left_out = 0; ///< of a look that was learnt from the others
};

struct Matched {
    lutlib::Match match;
    lutlib::Coverage coverage;
    lutlib::LookEncodings look;
    int bits = 0;             ///< of a sample after the grade; 0: floats
    std::size_t pixels = 0;   ///< learnt from
    std::size_t left_out = 0; ///< in places that were edited by themselves
    /// dE2000 of the look, as a file of so many bits holds it: of all pixels, and of a part that
    /// the look which was measured was not learnt from; none where the pictures are too small.
    lutlib::ErrorStats own;
    /// Of the variance after the grade, what the look explains there; of patches 1.
    double explained = 1;
    std::optional<lutlib::ErrorStats> held_out; ///< of patches: each from the others
    lutlib::ErrorStats rounding; ///< what such a file alone costs, on the held out part
    std::vector<MatchedPair> pairs;
    std::vector<MatchedPatch> patches; ///< in place of pairs
    std::vector<std::string> remarks;  ///< of all of it, a sentence each
};

/// Without a size, 33 or 32 nodes, whichever suits pixels better that it was not learnt from.
/// Throws Error, also where the look does not make the one picture of the other.
Matched match_pairs(std::span<const PairPaths> paths, const PairEncodings& encodings,
                    std::optional<int> size);

} // namespace converter
