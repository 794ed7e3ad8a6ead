// How a picture after a grade lies on the one before it.
//
// What survives any grade is that equal colours stay equal. So the pictures lie on each other where
// the colours of the one tell most about those of the other: by the correlation ratio, the share of
// the variance after the grade that its means over like colours before it explain (Roche,
// Malandain, Pennec and Ayache, "The Correlation Ratio as a New Similarity Measure for Multimodal
// Image Registration", MICCAI 1998).
#pragma once

#include "lutlib/engine/layout.h"

#include <optional>

namespace lutlib {

struct Shift {
    /// Pixel (x, y) before the grade is pixel (x + by.x, y + by.y) after it.
    Pixel by;
    double explained = 1; ///< the correlation ratio there, 0..1
    double left_over = 0; ///< the standard deviation of what is not explained, in code values
    double x_beyond = 0;  ///< what is left of a pixel, -0.5..0.5, to the right
    double y_beyond = 0;  ///< and down
    double explained_unmoved = 1; ///< the same ratio without any shift
};

/// By whole pixels, up to a quarter of a side; of pictures of one size. Pixels with a channel that
/// is not finite count nothing. Pictures below 32x32, and such as are of one colour, stay unmoved.
Shift find_shift(const Picture& before, const Picture& after);

/// Whether parts of the picture lie elsewhere than all of it: it was scaled, turned or bent. The
/// answer is by how many pixels more two parts are apart than before the grade; nothing where they
/// are not.
std::optional<Pixel> distortion_in(const Picture& before, const Picture& after, Pixel by);

/// The picture after the grade with each pixel where it was before it. What that does not show is
/// NaN.
Picture moved_back(const Picture& after, Pixel by);

} // namespace lutlib
