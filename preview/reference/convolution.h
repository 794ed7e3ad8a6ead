// Exact convolution by a float64 FFT, the oracle of what a bloom plan approximates.
#pragma once

#include "preview/reference/image.h"

#include <functional>

namespace preview::reference {

/// A normalised isotropic Gaussian of `sigma` texels at the distance (dx, dy).
double gaussian(double dx, double dy, double sigma);

/// The picture, continued beyond its border by `margin` of its border texels, convolved with
/// `kernel(dx, dy)` sampled at whole texels up to that distance and scaled to sum 1. Zero-padded,
/// so nothing wraps around.
Image convolved(const Image& picture, int margin,
                const std::function<double(double dx, double dy)>& kernel);

} // namespace preview::reference
