// Pairs of colours, before and after a grade, gathered into bins of like colours: what is learnt
// from pictures then costs as much as they have colours, however many pixels they have.
#pragma once

#include "lutlib/rgb.h"
#include "lutlib/transform.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lutlib {

/// One pixel of a pair of pictures.
struct PixelPair {
    Rgb before, after;
};

/// What stands for many pixels.
struct ColorPair {
    RgbD before, after;
    double weight = 1;
};

class ColorBins {
  public:
    /// The bins are cubes, `side` of them along each axis of 0..1, with `side` in 1..256. What a
    /// lattice over 0..1 reads is held to that before the grade; after it, to the largest half
    /// float. Pixels with a channel that is not finite are left out.
    ColorBins(std::vector<PixelPair> pixels, int side);

    std::size_t pixels() const { return pixels_.size(); }
    /// Bins that hold a pixel.
    std::size_t size() const { return first_.size() - 1; }

    /// The mean of each bin, with the number of its pixels as weight.
    std::vector<ColorPair> means() const;

    /// The same without what does not belong there. Pixels are judged by how far `after` is from
    /// `look` of `before`, against the median of their bin; beyond `limit`, in code values of
    /// 0..1, they count nothing, and less the nearer they are to it (Tukey's biweight).
    /// In the order of means(); a bin of which nothing is left has a weight of 0.
    std::vector<ColorPair> robust_means(const Transform& look, double limit) const;

    /// The standard deviation of a channel of `after` about `look` and the medians of the bins, by
    /// the median of all pixels' deviations: outliers have no part in it.
    double noise(const Transform& look) const;

  private:
    std::span<const PixelPair> bin(std::size_t i) const {
        return std::span(pixels_).subspan(first_[i], first_[i + 1] - first_[i]);
    }

    std::vector<PixelPair> pixels_;  ///< sorted by bin
    std::vector<std::size_t> first_; ///< of each bin, and the end
};

} // namespace lutlib
