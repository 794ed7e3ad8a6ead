// The straight line nearest to points, by least squares.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lutlib {

class LineFit {
  public:
    void add(double x, double y) {
        ++count_;
        x_ += x;
        y_ += y;
        xx_ += x * x;
        xy_ += x * y;
        yy_ += y * y;
    }
    std::size_t count() const { return count_; }
    /// 0 of points at one x.
    double slope() const { return across() > 0 ? both() / across() : 0; }
    /// The standard deviation of y from the line.
    double off() const {
        return std::sqrt(std::max(0.0, (up() - slope() * both()) / static_cast<double>(count_)));
    }
    /// The share of the squares of y about their mean that the line takes, 0..1.
    double explained() const {
        return across() > 0 && up() > 0 ? both() * both() / (across() * up()) : 0;
    }

  private:
    double across() const { return xx_ - x_ * x_ / static_cast<double>(count_); }
    double up() const { return yy_ - y_ * y_ / static_cast<double>(count_); }
    double both() const { return xy_ - x_ * y_ / static_cast<double>(count_); }

    std::size_t count_ = 0;
    double x_ = 0, y_ = 0, xx_ = 0, xy_ = 0, yy_ = 0;
};

} // namespace lutlib
