// Many pixels through a look as a program keeps it, in any storage, with the widest vectors that
// the processor has (Highway picks the code at run time) and on every core (oneTBB).
//
// The arithmetic is evaluate()'s, operation for operation, so that the results are its results:
// without fused multiply-adds, which would round differently from one processor to the next. A
// vector holds the places of several pixels while nodes and weights are found; then each pixel
// sums its own nodes, red, green and blue side by side, so that nothing has to be gathered.
#pragma once

#include "lutlib/interpolation/stored_lut.h"

#include <cstddef>
#include <span>

namespace lutlib {

/// Pixels of `channels` floats, 3 or 4, of which a fourth passes unchanged. `out` may be `in`, or
/// else must not overlap it. On the calling thread; allocates nothing.
void apply_on_this_thread(const StoredLut& lut, const Lookup& lookup, const float* in, float* out,
                          std::size_t pixels, std::size_t channels);

/// How many pixels have a colour outside the domain, NaN counted. On every core.
std::size_t pixels_outside(const Domain& domain, const float* in, std::size_t pixels,
                           std::size_t channels);

} // namespace lutlib
