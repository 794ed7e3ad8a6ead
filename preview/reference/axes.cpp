#include "preview/reference/axes.h"

#include "lutlib/ops/secondary.h"

#include <algorithm>
#include <cmath>

namespace preview::reference {

namespace {

class Counts {
  public:
    void add(std::size_t axis, double value, std::uint32_t count) {
        const CountedAxis& row = counted_axes[axis];
        const double share = (value - row.min) / (row.max - row.min);
        if (count == 0 || !(share >= 0 && share <= 1.0001)) {
            return;
        }
        const auto bin = static_cast<std::size_t>(share * axis_bins);
        bins_[axis * axis_bins + std::min<std::size_t>(bin, axis_bins - 1)] += count;
    }
    std::vector<std::uint32_t> take() { return std::move(bins_); }

  private:
    std::vector<std::uint32_t> bins_ = std::vector<std::uint32_t>(counted_axes.size() * axis_bins);
};

} // namespace

std::vector<std::uint32_t> axis_counts(std::span<const lutlib::RgbD> colors,
                                       const lutlib::Encoding& encoding) {
    const lutlib::Matrix3 cones = lutlib::oklab_cones(encoding.primaries());
    Counts counts;
    for (const lutlib::RgbD& color : colors) {
        const lutlib::RgbD codes{lutlib::saturate(color.r), lutlib::saturate(color.g),
                                 lutlib::saturate(color.b)};
        const lutlib::RgbD lab = lutlib::oklab_from_lms(
            cones * lutlib::RgbD{encoding.decode(codes.r), encoding.decode(codes.g),
                                 encoding.decode(codes.b)});
        counts.add(0, lab.r, 1);
        counts.add(1, lutlib::op::saturation_of(lab), 1);
        counts.add(2, std::fmod(lutlib::dial_hue(lab.g, lab.b) + 180.0 / axis_bins, 360.0),
                   static_cast<std::uint32_t>(std::lround(hue_unit * lutlib::op::hue_weight(lab))));
        counts.add(3, 0.2126 * codes.r + 0.7152 * codes.g + 0.0722 * codes.b, 1);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            counts.add(4 + channel, codes[channel], 1);
        }
    }
    return counts.take();
}

} // namespace preview::reference
