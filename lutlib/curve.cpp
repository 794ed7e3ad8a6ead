#include "lutlib/curve.h"

#include "lutlib/error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace lutlib {
namespace {

constexpr double largest_coordinate = 1e9;

void check(const Knots& knots) {
    for (const Knot& k : knots) {
        if (!(std::abs(k.x) <= largest_coordinate) || !(std::abs(k.y) <= largest_coordinate)) {
            throw Error("a curve's knot is not finite or is beyond 1e9",
                        {"", 0, std::to_string(k.x) + ":" + std::to_string(k.y)});
        }
    }
}

// Sorted by x; knots that follow each other within `apart` become their mean.
Knots merged(Knots knots, double apart) {
    std::stable_sort(knots.begin(), knots.end(),
                     [](const Knot& a, const Knot& b) { return a.x < b.x; });
    Knots out;
    for (std::size_t first = 0; first < knots.size();) {
        std::size_t end = first;
        Knot sum;
        while (end < knots.size() && knots[end].x - knots[first].x <= apart) {
            sum.x += knots[end].x;
            sum.y += knots[end].y;
            ++end;
        }
        const auto count = static_cast<double>(end - first);
        out.push_back(end - first == 1 ? knots[first] : Knot{sum.x / count, sum.y / count});
        first = end;
    }
    return out;
}

// The tangent between two intervals of widths h and slopes s.
double tangent(double h0, double s0, double h1, double s1) {
    if (s0 * s1 <= 0) {
        return 0;
    }
    const double w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
    return (w0 + w1) / (w0 / s0 + w1 / s1);
}

double reduce(double x, double period) {
    // Several times faster than std::fmod; rounding may give `period` itself, which is place 0.
    return x - period * std::floor(x / period);
}

} // namespace

Curve Curve::open(Knots knots, double if_empty) {
    check(knots);
    if (knots.empty()) {
        knots.push_back({0, if_empty});
    }
    const auto [low, high] = std::minmax_element(
        knots.begin(), knots.end(), [](const Knot& a, const Knot& b) { return a.x < b.x; });
    const double width = high->x - low->x;
    return Curve(merged(std::move(knots), 1e-9 * width), 0);
}

Curve Curve::periodic(Knots knots, double period, double if_empty) {
    check(knots);
    if (knots.empty()) {
        knots.push_back({0, if_empty});
    }
    const double apart = 1e-9 * period;
    for (Knot& k : knots) {
        k.x = reduce(k.x, period);
        // Just below a full turn is the place of 0.
        k.x = period - k.x <= apart ? 0 : k.x;
    }
    return Curve(merged(std::move(knots), apart), period);
}

Curve::Curve(const Knots& merged, double period) : period_(period) {
    Knots knots = merged;
    if (period > 0) {
        knots.push_back({merged.front().x + period, merged.front().y});
    }
    last_x_ = knots.back().x;
    last_y_ = knots.back().y;
    const std::size_t n = knots.size();
    if (n == 1) {
        segments_.push_back({knots[0].x, {knots[0].y, 0, 0, 0}});
        return;
    }
    std::vector<double> width(n - 1), slope(n - 1), m(n);
    for (std::size_t i = 0; i + 1 < n; ++i) {
        width[i] = knots[i + 1].x - knots[i].x;
        slope[i] = (knots[i + 1].y - knots[i].y) / width[i];
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
        m[i] = tangent(width[i - 1], slope[i - 1], width[i], slope[i]);
    }
    if (period > 0) {
        m[0] = m[n - 1] = tangent(width[n - 2], slope[n - 2], width[0], slope[0]);
    } else {
        m[0] = slope[0];
        m[n - 1] = slope[n - 2];
    }
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const double h = width[i], s = slope[i];
        segments_.push_back({knots[i].x,
                             {knots[i].y, m[i], (3 * s - 2 * m[i] - m[i + 1]) / h,
                              (m[i] + m[i + 1] - 2 * s) / (h * h)}});
        if (i > 0) {
            starts_.push_back(knots[i].x);
        }
    }
}

double Curve::operator()(double x) const {
    if (period_ > 0) {
        x = reduce(x, period_);
        x = x < segments_.front().x ? x + period_ : x;
    }
    if (!(x > segments_.front().x)) {
        return segments_.front().c[0];
    }
    if (x >= last_x_) {
        return last_y_;
    }
    // Counting has no branch to mispredict.
    std::size_t i = 0;
    for (const double start : starts_) {
        i += x >= start;
    }
    const Segment& s = segments_[i];
    const double t = x - s.x;
    return s.c[0] + t * (s.c[1] + t * (s.c[2] + t * s.c[3]));
}

} // namespace lutlib
