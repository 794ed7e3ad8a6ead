// Smooth curves through knots that a person draws: they never overshoot, so a curve whose knots
// rise rises everywhere.
//
// Between knots the curve is the cubic Hermite spline of F. N. Fritsch and R. E. Carlson, "Monotone
// Piecewise Cubic Interpolation", SIAM J. Numer. Anal. 17(2), 1980, with the tangents of F. N.
// Fritsch and J. Butland (1984): a weighted harmonic mean of the neighbouring slopes, zero where
// they differ in sign. It is continuous with a continuous derivative. Outside its knots an open
// curve is flat: it keeps the value of its first or last knot. A periodic curve has no outside.
#pragma once

#include <array>
#include <vector>

namespace lutlib {

struct Knot {
    double x = 0, y = 0;
    friend bool operator==(const Knot&, const Knot&) = default;
};

using Knots = std::vector<Knot>;

class Curve {
  public:
    /// Knots in any order. Knots nearer to each other than 1e-9 of the curve's width become one,
    /// at their mean. One knot makes a constant; none make the constant `if_empty`. Throws Error
    /// for a coordinate that is not finite or beyond 1e9 in magnitude.
    static Curve open(Knots knots, double if_empty = 0);

    /// The same on a circle of circumference `period` > 0: x and x + period are one place.
    static Curve periodic(Knots knots, double period, double if_empty = 0);

    /// Of every x; NaN reads as the first knot's place.
    double operator()(double x) const;

    double first_x() const { return segments_.front().x; }
    double last_x() const { return last_x_; }

  private:
    // From x on, y = c0 + t (c1 + t (c2 + t c3)) with t = x' - x.
    struct Segment {
        double x;
        std::array<double, 4> c;
    };

    explicit Curve(const Knots& merged, double period);

    std::vector<Segment> segments_;
    std::vector<double> starts_; ///< the segments' x after the first, for the search
    double last_x_ = 0, last_y_ = 0;
    double period_ = 0;
};

} // namespace lutlib
