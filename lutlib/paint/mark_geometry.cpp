#include "lutlib/paint/mark_geometry.h"

#include "lutlib/paint/line_fit.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// Pixels that an edge may lie from where those before it lead to.
constexpr int reach = 2;
constexpr std::size_t fewest = 5;
// Pixels, that edges may lie beside a line in the mean.
constexpr double straight = 0.5;

double sum(Rgb c) {
    return static_cast<double>(c.r) + static_cast<double>(c.g) + static_cast<double>(c.b);
}

// Where `value` crosses `middle` nearest to `near`, as it does from one whole place to the next.
template <class F>
std::optional<double> crossing(double near, double middle, bool rises, F&& value) {
    std::optional<double> out;
    const int first = static_cast<int>(std::floor(near)) - reach;
    for (int at = first; at <= first + 2 * reach; ++at) {
        const double here = value(at) - middle, next = value(at + 1) - middle;
        if ((rises ? here < 0 && next >= 0 : here >= 0 && next < 0)) {
            const double place = at + here / (here - next);
            if (!out || std::abs(place - near) < std::abs(*out - near)) {
                out = place;
            }
        }
    }
    return out;
}

class Measure {
  public:
    Measure(const Picture& upright, const FoundStrip& strip)
        : picture_(upright),
          at_(*strip.mark_at), rows_{mark_row(strip.framed, 0), mark_row(strip.framed, 1)} {
        double light = 0, dark = 0, lights = 0, darks = 0;
        for (int row = 0; row < 2; ++row) {
            for (int i = 0; i < mark_cells; ++i) {
                const double value = at(at_.x + i * mark_cell + mark_cell / 2,
                                        at_.y + row * mark_cell + mark_cell / 2);
                (is_light(row, i) ? light : dark) += value;
                ++(is_light(row, i) ? lights : darks);
            }
        }
        light /= std::max(1.0, lights);
        dark /= std::max(1.0, darks);
        middle_ = (light + dark) / 2;
        is_negative_ = light < dark;
    }

    std::optional<MarkGeometry> run() const {
        const LineFit along = edges_along(), between = edges_between();
        if (along.count() < fewest || between.count() < fewest || along.off() > straight ||
            between.off() > straight) {
            return std::nullopt;
        }
        // What a turn takes from the length of the rows it puts across them.
        const double right = along.slope(), down = between.slope();
        constexpr double degrees_a_radian = 57.29577951308232;
        return MarkGeometry{std::hypot(right, down), degrees_a_radian * std::atan2(down, right)};
    }

  private:
    bool is_light(int row, int cell) const {
        return rows_[static_cast<std::size_t>(row)][static_cast<std::size_t>(cell)];
    }
    // Beyond the picture as at its edge.
    double at(int x, int y) const {
        return sum(picture_.at(std::clamp(x, 0, picture_.width - 1),
                               std::clamp(y, 0, picture_.height - 1)));
    }
    bool rises(bool to_light) const { return to_light != is_negative_; }

    // Of both rows, against where they were placed; each edge is looked for where the one before it
    // leads to.
    LineFit edges_along() const {
        LineFit out;
        for (int row = 0; row < 2; ++row) {
            const int y = at_.y + row * mark_cell + mark_cell / 2;
            double drift = -0.5; // a step lies between two pixels' centres
            for (int i = 1; i < mark_cells; ++i) {
                if (is_light(row, i) == is_light(row, i - 1)) {
                    continue;
                }
                const double placed = i * mark_cell;
                const std::optional<double> found =
                    crossing(at_.x + placed + drift, middle_, rises(is_light(row, i)),
                             [&](int x) { return at(x, y); });
                if (found) {
                    drift = *found - at_.x - placed;
                    out.add(placed, *found);
                }
            }
        }
        return out;
    }

    // Of cells that differ from the one below, against where along the mark they were placed.
    LineFit edges_between() const {
        LineFit out;
        for (int i = 0; i < mark_cells; ++i) {
            if (is_light(0, i) == is_light(1, i)) {
                continue;
            }
            const int middle_of_cell = i * mark_cell + mark_cell / 2;
            const std::optional<double> found =
                crossing(at_.y + mark_cell - 0.5, middle_, rises(is_light(1, i)),
                         [&](int y) { return at(at_.x + middle_of_cell, y); });
            if (found) {
                out.add(middle_of_cell, *found);
            }
        }
        return out;
    }

    const Picture& picture_;
    Pixel at_;
    std::array<MarkRow, 2> rows_;
    double middle_ = 0;
    bool is_negative_ = false;
};

} // namespace

std::optional<MarkGeometry> mark_geometry(const Picture& upright, const FoundStrip& strip) {
    return Measure(upright, strip).run();
}

} // namespace lutlib
