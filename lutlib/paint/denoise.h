// Takes the noise of 8 bits, dithering and lossy files off a lattice, and leaves its grade.
#pragma once

#include "lutlib/lut.h"

#include <cstddef>

namespace lutlib {

struct Denoised {
    Lut3D cube;
    std::size_t moved = 0;        ///< nodes whose values changed
    double mean = 0, largest = 0; ///< of the changes of a channel, in codes of 8 bits
    double limit = 0;             ///< the same that no change exceeds
};

/// Smooths along the three axes by Whittaker's smoother ("On a New Method of Graduation",
/// Proceedings of the Edinburgh Mathematical Society 41, 1922) with third differences, as much as
/// takes off a standard deviation of `noise` codes of 8 bits and no more; rows that rise or fall
/// but for the noise then become the nearest row that does so, as far as no value moves too far.
/// Values at 0 and 1 stay: a grade clips there. No value moves by more than three times the noise,
/// or three quarters of a code where that is less.
Denoised denoised(const Lut3D& cube, double noise);

} // namespace lutlib
