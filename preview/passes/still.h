// A finished picture compared with a reference still, or two stills with each other.
#pragma once

#include "preview/finish/compare.h"
#include "preview/finish/wipe.h"
#include "preview/passes/finish.h"
#include "preview/passes/pass.h"

#include <array>

namespace preview {

/// What one side shows, in an image as large as the picture.
struct StillSide {
    ImageHandle picture; ///< empty: the comparison does not show this side
    Size extent;         ///< of what it shows, in the middle of the image
};

struct StillFit {
    Format of_output = Format::rgba8; ///< of what it is compared with
    bool is_kept = false;             ///< as ResolveWork has it
    std::string_view name = "still";  ///< tells it from another
};

/// A still as large as a picture of that size, between bars where it has other proportions.
StillSide add_fitted_still(Graph& graph, ImageHandle still, Size size, const StillFit& how);

/// Where the picture of a still stands in an image of that size: its corner and its extent.
std::array<std::int32_t, 4> place_of(Size extent, Size size);

struct StillSettings {
    const Compare* compare = nullptr;
    WipeShape wipe{};
    float heat_scale = 8;
    bool has_marks = true; ///< draw the border or the heat map's scale
    Format format = Format::rgba8;
};

/// Both sides as the comparison shows them; side by side the image is twice as wide.
Finished add_still_comparison(Graph& graph, const std::array<StillSide, 2>& sides, Size size,
                              const StillSettings& settings);

} // namespace preview
