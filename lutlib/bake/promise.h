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

    /// The largest error of point samples over the remembered colours, and over the union grid
    /// where the eye sees most of the look's codes, from the nodes around them alone; or one that
    /// exceeds `limit`, the first that is met.
    double glance(int size, int bits, double limit);

    /// The first error met that exceeds `limit`, else the largest of all, climbed.
    double largest_error(const Bake& bake, double limit);

  private:
    class Candidates;

    double glance_at_remembered(int size, CodeDepth depth, double limit);
    double glance_at_delicate(int size, CodeDepth depth, double limit);
    std::vector<RgbD> read_point_samples(int size, CodeDepth depth, std::span<const Rgb> in) const;
    double first_beyond(double limit, const Transform& lookup, std::span<const Rgb> in,
                        Candidates& candidates);
    double along_planes(double limit, const Transform& lookup, const UnionAxes& axis,
                        Candidates& candidates);
    void error_of(const Transform& lookup, std::span<const Rgb> in, std::span<double> errors) const;
    void remember(std::span<const Rgb> colors, std::span<const double> errors);

    const Engine& engine_;
    const Budget& budget_;
    const Transform look_;
    const Eye eye_;
    std::vector<Rgb> remembered_;
    std::vector<RgbD> expected_;   // of the remembered
    std::vector<Domain> delicate_; // of the inputs, boxes where the eye sees most, those first
};

} // namespace lutlib
