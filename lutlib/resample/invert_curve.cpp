#include "lutlib/resample/invert_curve.h"

#include "lutlib/error.h"
#include "lutlib/resample/curves.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace lutlib {
namespace {

constexpr double inverse_tolerance = 1e-6;
constexpr int least_entries = 4096;

/// One channel of a table made rising, from its lowest value to its highest: points whose inputs
/// and values do not fall.
class MonotoneChannel {
  public:
    MonotoneChannel(const Lut1D& curve, std::size_t c) {
        const double first = curve.entries.front()[c], last = curve.entries.back()[c];
        if (first == last) {
            throw Error(std::string("the 1D table of channel ") + "rgb"[c] +
                        " begins and ends at the same value, so it has no inverse");
        }
        // A falling table is a rising one from its other end.
        falls_ = last < first;
        const int n = curve.size();
        for (int k = 0; k < n; ++k) {
            const int i = falls_ ? n - 1 - k : k;
            add(entry_position(curve, i)[c], curve.entries[static_cast<std::size_t>(i)][c]);
        }
        measure();
    }

    const CurveInversion::Channel& facts() const { return facts_; }
    double low() const { return points_.front().y; }
    double high() const { return points_.back().y; }

    /// The input that gives `y`; of a flat end the one beside the rise, of another flat part the
    /// nearest to `y`.
    double inverse(double y) const {
        y = std::clamp(y, low(), high());
        const auto [first, beyond] = at(y);
        if (beyond != first) {
            return first == points_.begin()  ? (beyond - 1)->x
                   : beyond == points_.end() ? first->x
                                             : nearest(y);
        }
        const Point& a = *(first - 1);
        const double t = (y - a.y) / (first->y - a.y);
        return a.x * (1 - t) + first->x * t;
    }

    /// Of the inputs that give the value `y` of some point, the nearest to it.
    double nearest(double y) const {
        const auto [first, beyond] = at(y);
        const auto [a, b] = std::minmax(first->x, (beyond - 1)->x);
        return std::clamp(y, a, b);
    }

  private:
    struct Point {
        double x, y;
    };
    using Place = std::vector<Point>::const_iterator;

    /// The first point that reaches `y`, and the first beyond it.
    std::pair<Place, Place> at(double y) const {
        const Place first = std::partition_point(points_.begin(), points_.end(),
                                                 [y](const Point& p) { return p.y < y; });
        return {first, std::partition_point(first, points_.end(),
                                            [y](const Point& p) { return p.y <= y; })};
    }

    void add(double x, double y) {
        if (points_.empty()) {
            points_.push_back({x, y});
            return;
        }
        const Point last = points_.back();
        const double before = previous_.value_or(last.y);
        previous_ = y;
        const double width = std::abs(x - last_x_.value_or(last.x));
        const double last_x = last_x_.value_or(last.x);
        last_x_ = x;
        if (y <= last.y) {
            (y == before && y == last.y ? facts_.flat : facts_.turned) += width;
            facts_.depth = std::max(facts_.depth, last.y - y);
            points_.push_back({x, last.y});
            return;
        }
        if (before < last.y) {
            // It comes back out of a dip within this step.
            const double t = (last.y - before) / (y - before);
            facts_.turned += width * t;
            points_.push_back({last_x + (x - last_x) * t, last.y});
        }
        points_.push_back({x, y});
    }

    void measure() {
        const auto slope = [](const Point& a, const Point& b) { return (b.x - a.x) / (b.y - a.y); };
        const auto rises = [](const Point& a, const Point& b) { return b.y > a.y; };
        const auto first = std::adjacent_find(points_.begin(), points_.end(), rises);
        const auto last =
            std::adjacent_find(points_.rbegin(), points_.rend(),
                               [&](const Point& b, const Point& a) { return rises(a, b); });
        facts_.slope_low = slope(*first, *(first + 1));
        facts_.slope_high = slope(*(last + 1), *last);
    }

    std::vector<Point> points_;
    std::optional<double> previous_, last_x_; ///< of the table's own entry before
    bool falls_ = false;
    CurveInversion::Channel facts_;
};

} // namespace

CurveInversion invert_curve(const Lut1D& curve, const InvertCurveOptions& options) {
    const std::array<MonotoneChannel, 3> channels{
        MonotoneChannel(curve, 0), MonotoneChannel(curve, 1), MonotoneChannel(curve, 2)};
    CurveInversion out;
    Domain values;
    for (std::size_t c = 0; c < 3; ++c) {
        out.channels[c] = channels[c].facts();
        values.min[c] = static_cast<float>(channels[c].low());
        values.max[c] = static_cast<float>(channels[c].high());
    }
    const Transform exact = Transform::each([&channels](RgbD y) {
        return RgbD{channels[0].inverse(y.r), channels[1].inverse(y.g), channels[2].inverse(y.b)};
    });
    const Domain domain = options.domain.value_or(values);
    if (options.size) {
        out.curve = sample_curve(exact, domain, *options.size);
    } else {
        out.curve = sample_curve_closely(exact, domain, std::max(curve.size(), least_entries),
                                         inverse_tolerance);
    }
    // Of what a flat end holds, the input nearest to the value.
    for (std::size_t c = 0; c < 3; ++c) {
        if (domain.min[c] == values.min[c]) {
            out.curve.entries.front()[c] =
                static_cast<float>(channels[c].nearest(channels[c].low()));
        }
        if (domain.max[c] == values.max[c]) {
            out.curve.entries.back()[c] =
                static_cast<float>(channels[c].nearest(channels[c].high()));
        }
    }
    return out;
}

double inverse_of_curve(const Lut1D& curve, double y, std::size_t channel) {
    const auto entry = [&](int i) {
        return static_cast<double>(curve.entries[static_cast<std::size_t>(i)][channel]);
    };
    const int n = curve.size();
    const double sign = entry(n - 1) > entry(0) ? 1 : -1;
    int low = 0, high = n - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (sign * entry(middle) <= sign * y ? low : high) = middle;
    }
    const double t = std::clamp((y - entry(low)) / (entry(low + 1) - entry(low)), 0.0, 1.0);
    return entry_position(curve, low)[channel] * (1 - t) +
           entry_position(curve, low + 1)[channel] * t;
}

void check_invertible(const Lut1D& curve) {
    for (std::size_t c = 0; c < 3; ++c) {
        const bool rises = curve.entries.front()[c] < curve.entries.back()[c];
        for (std::size_t i = 0; i + 1 < curve.entries.size(); ++i) {
            const float a = curve.entries[i][c], b = curve.entries[i + 1][c];
            if (!(rises ? a < b : a > b)) {
                throw Error(std::string("the 1D table of channel ") + "rgb"[c] +
                            " is flat or not monotonic at entry " + std::to_string(i + 1) +
                            ", so it has no inverse");
            }
        }
    }
}

} // namespace lutlib
