// The float table that stands for a recipe on the screen, and how far it is from that.
#pragma once

#include "lutlib/recipe/recipe.h"
#include "preview/look/look_bake.h"

#include <functional>
#include <optional>

namespace preview {

struct RecipeTable {
    lutlib::Lut lut;
    int nodes = 0; ///< a side
    /// dE2000 between the table, read tetrahedrally, and the look: over colours spread evenly over
    /// the table's inputs, and the largest seen where errors hide (lutlib/metrics/error_samples.h)
    /// and uphill from there.
    double max_error = 0, mean_error = 0;
};

/// Differences below it are not seen side by side.
inline constexpr double visible_difference = 1;

/// As fast as editing wants it, and not measured.
lutlib::Lut quick_table(const lutlib::Recipe& recipe);
/// The same of any look.
lutlib::Lut quick_table(const lutlib::Transform& look);

/// The smallest of a few tables without a visible difference to the recipe, else the largest. Asks
/// `stop`, from any thread but one at a time, every few milliseconds to some tens, and returns
/// nothing once that says so.
std::optional<RecipeTable> measured_table(
    const lutlib::Recipe& recipe, const std::function<bool()>& stop = [] { return false; });

/// The table for a lookup that reads tables, with a note as "65 nodes per axis, dE2000 0.020 on
/// average and 0.41 at most, as far as seen, of the look itself".
LoadedLook measured_look(const RecipeTable& table, const GpuLookup& lookup);

} // namespace preview
