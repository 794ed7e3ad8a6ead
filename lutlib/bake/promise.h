// Whether a bake's largest error stays within a limit, found out as quickly as may be.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/bake/budget.h"

#include <span>
#include <vector>

namespace lutlib {

/// Remembers the colours that broke the promise before, or nearly: of other sizes one of them
/// mostly does again.
class PromiseCheck {
  public:
    PromiseCheck(const Transform& look, const Engine& engine, const Budget& budget);

    /// The largest error of point samples over the remembered colours, from the nodes around them
    /// alone; or one that exceeds `limit`, the first that is met.
    double glance(int size, int bits, double limit);

    /// The first error met that exceeds `limit`, else the largest of all, climbed.
    double largest_error(const Bake& bake, double limit);

  private:
    std::vector<RgbD> read_point_samples(int size, CodeDepth depth, std::span<const Rgb> in) const;
    void remember(std::span<const Rgb> colours, std::span<const double> errors);

    const Engine& engine_;
    const Budget& budget_;
    const Transform look_;
    const Eye eye_;
    std::vector<Rgb> remembered_;
    std::vector<RgbD> expected_; // of the remembered
    ErrorSamples samples_;       // of the size checked last
    std::vector<RgbD> right_;
    int samples_size_ = 0;
};

} // namespace lutlib
