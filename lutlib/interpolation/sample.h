// One sample of a picture as a number, and back.
#pragma once

#include "lutlib/interpolation/picture_view.h"

#include <cstddef>

namespace lutlib {

/// Codes over their maximum, exactly rounded; halves and floats as they are, NaN and infinities
/// too.
double sample_value(Element element, const std::byte* at);

/// The nearest that the element holds: codes of 0..1, the upper of two that are equally near;
/// halves up to +-65504; floats, which are held to their range. NaN is 0.
void store_sample(Element element, double value, std::byte* at);

/// Samples, `in_step` and `out_step` bytes apart, from one element to another; between equal ones
/// the bits.
void copy_samples(Element from, const std::byte* in, std::ptrdiff_t in_step, Element to,
                  std::byte* out, std::ptrdiff_t out_step, std::size_t count);

} // namespace lutlib
