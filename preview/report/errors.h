// How far what the GPU has made is from what it should be.
#pragma once

#include "lutlib/metrics/stats.h"
#include "preview/gpu/size.h"
#include "preview/reference/image.h"

#include <optional>
#include <span>

namespace preview::report {

/// Of what a pass makes by itself.
struct PassError {
    double relative_l2 = 0; ///< |got - wanted| / |wanted| over all texels and channels
    double drift = 0;       ///< of the channel that is worst: more light in all, as a share
    /// Of an impulse alone: how unlike the texels of a ring about it are but for a slope along its
    /// radius, as an L2 share of all;
    /// and how far the middle of the light is from where it should be, in texels.
    std::optional<double> asymmetry, centroid_shift;
    /// Of a pan by whole texels: by how much a texel of the scene changes from frame to frame, as
    /// a share of the mean square of its light (a root).
    std::optional<double> unrest;
};
/// Of images of one size. Without light in `wanted` the error is that of `got` itself, or 0.
PassError pass_error(const reference::Image& got, const reference::Image& wanted,
                     std::optional<Size> impulse = {});

/// Of the finished picture, in display codes that are read as sRGB.
struct PictureError {
    double relative_l2 = 0;
    double largest = 0; ///< of any channel, in codes of 0..1
    lutlib::ErrorStats delta_e_2000, delta_e_itp;
};
PictureError picture_error(const reference::Image& got, const reference::Image& wanted);

/// The same of a pan that moves nothing by whole texels: how much the error of a texel changes from
/// frame to frame, as such a share of what should be there.
double unrest_of_error(std::span<const reference::Image> got,
                       std::span<const reference::Image> wanted);

/// As PassError::unrest: `frames[k]` has everything k * `step` texels farther to the left than
/// `frames[0]`. What leaves the picture does not count.
double unrest(std::span<const reference::Image> frames, int step);

/// As PassError::asymmetry.
double asymmetry(const reference::Image& image, Size centre);

/// Box filter: each texel the mean of `times` by `times` of a picture that many times as large.
reference::Image averaged(const reference::Image& large, int times);

} // namespace preview::report
