// Pictures from samples of their file's type to floats and back.
#pragma once

#include "lutlib/io/image.h"

#include <functional>

namespace lutlib::io {

/// Integer codes c of b bits become c / (2^b - 1).
FloatImage floats_of(SampleImage&& image);

/// Integer samples are clamped to 0..1 (NaN to 0); halves are held to +-65504, but infinities and
/// NaN stay. All are rounded to nearest. With alpha or without it. `memory` may give the samples
/// their place; what it gives empty is taken from the heap.
SampleImage
samples_of(const FloatImage& image, Depth depth, bool alpha,
           const std::function<SampleBuffer(const SampleImage& without_samples)>& memory = {});

/// Whether there is no alpha, or all of it is 1.
bool is_opaque(const SampleImage& image);

} // namespace lutlib::io
