// What pictures that were compressed with losses still say of a look.
#pragma once

#include "lutlib/engine/layout.h"

namespace lutlib {

struct FlatMeans {
    Picture before, after;
};

/// The means of 5x5 pixels around each, of pictures of one size; NaN where the picture before is
/// not flat there, and where one of the 25 is not finite in both. What JPEG does to a pixel after
/// the grade (noise of its blocks, colour at half the resolution) goes away in such means, and the
/// look of a mean is the mean of the look's results as far as the colours lie close together. Flat
/// is what has standard deviations of up to 8 codes of 8 bits in each channel, or the flatter half
/// of the picture where that is more.
FlatMeans flat_means(const Picture& before, const Picture& after);

} // namespace lutlib
