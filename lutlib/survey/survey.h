// What every way of keeping a look costs in error, in bytes and in time: each combination worth
// considering of lattice size, shaper, storage, lookup and filling, measured.
#pragma once

#include "lutlib/interpolation/stored_lut.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/survey/details.h"
#include "lutlib/survey/display.h"
#include "lutlib/survey/strain.h"
#include "lutlib/survey/timing.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

/// A 1D table before the lattice: none, srgb, log, pq, the look's own, or the one that the recipe
/// is baked with.
struct ShaperChoice {
    std::string_view name;
    std::string_view label;
    std::string_view bake_name; ///< of bake_recipe()
    bool recipe = false;        ///< what the recipe itself asks for
};

struct Combination {
    int size = 0;
    const ShaperChoice* shaper = nullptr;
    const Storage* storage = nullptr;
    const Lookup* lookup = nullptr;
    bool fitted = false;
};
/// "17 nodes, log shaper, 8 bits, tetrahedral, fitted"
std::string to_text(const Combination& c);

struct SurveyRow {
    Combination what;
    Difference error;
    std::size_t bytes = 0;
    double bake_seconds = 0;
    Timing pixel; ///< seconds a pixel on one core; of an emulated lookup, the emulation's
};

struct SurveySettings {
    std::vector<int> sizes{8, 16, 17, 25, 32, 33, 49, 64, 65};
    bool own_size = true; ///< the size that the recipe is baked to is tried too
    /// Of an output that displays take: as light would be, not as they show it.
    bool unclamped = false;
    /// On which errors are measured: enough that the largest, climbed, is within a few percent of
    /// that over all of the union grid.
    SampleLimits samples{
        .even = 10'000, .grid = std::size_t{1} << 14, .between = std::size_t{1} << 12};
    int pixels = 16384; ///< of a timed run
    int rounds = 15;    ///< of timed runs, each combination once in each
    double promise = 1; ///< largest dE2000 of the recommendation
};

/// Indices of rows. The smallest whose largest dE2000 is within the promise, the faster of equally
/// small ones; else the one whose largest is least, with `kept` false.
struct Recommendation {
    std::size_t row = 0;
    std::size_t fastest = 0; ///< the fastest that keeps the promise
    bool kept = false;
};
Recommendation recommend(const std::vector<SurveyRow>& rows, double max_delta_e);

struct Survey {
    std::vector<SurveyRow> rows;
    std::vector<std::string> notes; ///< what was left out, and why
    std::size_t colors = 0;         ///< of means and percentiles
    bool largest_seen = false;      ///< the maxima may not be the largest of all
    SurveySettings settings;
    bool clamped = false;   ///< every result is held to 0..1, as a display holds it
    OutsideDisplay outside; ///< of the look's own results
    DetailColors detail_colors;
    std::vector<Details> details; ///< of each row
    Recommendation recommendation;
    Strain strain;
};

/// From 0 to 1, and what is being done.
using Progress = std::function<void(double share, const std::string& doing)>;

/// Whether a lookup stands for what texture units do: its time is then the emulation's.
inline bool is_emulated(const Lookup& lookup) {
    return lookup.fraction_bits > 0;
}

/// The reference is the recipe, evaluated exactly. Where its output is for displays, both sides are
/// held to 0..1 as those do, unless the settings say otherwise. Every row's errors are
/// row_errors()'.
Survey survey(const Recipe& recipe, const SurveySettings& settings, const Progress& progress);

} // namespace lutlib
