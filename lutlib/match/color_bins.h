// Pairs of colours, before and after a grade, gathered into bins of like colours: what is learnt
// from pictures then costs as much as they have colours, however many pixels they have.
#pragma once

#include "lutlib/rgb.h"
#include "lutlib/transform.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lutlib {

/// One pixel of a pair of pictures.
struct PixelPair {
    Rgb before, after;
};

/// Of each channel after a grade: 1 where its codes end above and -1 where they end below, so that
/// a look may give more, or less, than the code; else 0.
using Clipped = std::array<std::int8_t, 3>;

/// How far colours are from what a look makes of them: `after` less `look`, and nothing where the
/// look goes beyond a code that was clipped.
constexpr RgbD off_by(RgbD after, RgbD look, const Clipped& clipped) {
    RgbD out = after - look;
    for (std::size_t c = 0; c < 3; ++c) {
        if (out[c] * clipped[c] < 0) {
            out[c] = 0;
        }
    }
    return out;
}

/// What stands for many pixels.
struct ColorPair {
    RgbD before, after;
    double weight = 1;
    Clipped clipped{};
};

/// Of a channel after a grade, standard deviations in 0..1.
struct PixelNoise {
    double rounding = 0; ///< the same in all pixels of one colour
    double own = 0;      ///< each pixel's
};

class ColorBins {
  public:
    /// The bins are cubes, `side` of them along each axis of 0..1, with `side` in 1..256. What a
    /// lattice over 0..1 reads is held to that before the grade; after it, to the largest half
    /// float. Pixels with a channel that is not finite are left out. `codes_end`: after the grade
    /// 0 and 1 stand for all that is beyond them, too. `nodes`: along each axis of the lattice that
    /// shall learn from them; 0: there is none.
    ColorBins(std::vector<PixelPair> pixels, int side, bool codes_end = false, int nodes = 0);

    std::size_t pixels() const { return pixels_; }
    /// Colours that stand for their pixels: one a bin, and one more for each other set of channels
    /// that are clipped in it, and each other tetrahedron of the lattice: within one the lattice is
    /// linear, so that the mean of what it gives is what it gives for the mean, however sharply it
    /// bends from one to the next.
    std::size_t size() const { return groups_.size(); }

    /// Their means, with the number of their pixels as weight.
    std::vector<ColorPair> means() const;

    /// The same without what does not belong there. Pixels are judged by how far `after` is from
    /// `look` of `before`, against the median of their bin; beyond `limit`, in code values of
    /// 0..1, they count nothing, and less the nearer they are to it (Tukey's biweight).
    /// In the order of means(); of what nothing is left has a weight of 0. Pixels of one colour
    /// before the grade share what rounding took from them: the weight is the number of pixels of
    /// different colours that would tell as much. A code that was clipped was not rounded, and a
    /// colour of which many say so counts by their square root at least.
    std::vector<ColorPair> robust_means(const Transform& look, double limit,
                                        const PixelNoise& noise = {0, 1}) const;

    /// The standard deviation of a channel of `after` about `look` and the medians of the bins, by
    /// the median of all pixels' deviations: outliers have no part in it.
    double noise(const Transform& look) const;

  private:
    // Pixels that are the same.
    struct Entry {
        Rgb before, after;
        std::uint32_t count;
    };
    struct Group {
        std::size_t end; ///< of its entries, which begin where the group before it ends
        Clipped clipped;
        std::uint64_t key; ///< the same for what belongs together
    };
    // Of a bin, its entries and groups.
    struct Bin {
        std::size_t entry, group;
    };

    std::span<const Entry> entries(std::size_t bin) const {
        return std::span(entries_).subspan(bins_[bin].entry,
                                           bins_[bin + 1].entry - bins_[bin].entry);
    }
    void find_off(std::size_t bin, const Transform& look, std::vector<RgbD>& off) const;

    std::size_t pixels_ = 0;
    std::vector<Entry> entries_; ///< by bin, clipped channels, and colours before and after
    std::vector<Group> groups_;
    std::vector<Bin> bins_; ///< those that hold a pixel, and the end
};

} // namespace lutlib
