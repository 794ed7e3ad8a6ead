#include "lutlib/match/flat_means.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lutlib {
namespace {

constexpr int reach = 2;
constexpr double flat = 8 / 255.0;

// Sums over a window, of each channel.
struct Sums {
    RgbD before, squares, after;
    double count = 0;

    void add(const Sums& more) {
        before = before + more.before;
        squares = squares + more.squares;
        after = after + more.after;
        count += more.count;
    }
    // The largest standard deviation of a channel before the grade.
    double deviation() const {
        double most = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double mean = before[c] / count;
            most = std::max(most, squares[c] / count - mean * mean);
        }
        return std::sqrt(most);
    }
};

Sums sums_of(Rgb before, Rgb after) {
    const RgbD b = to_double(before);
    return {b, {b.r * b.r, b.g * b.g, b.b * b.b}, to_double(after), 1};
}

// Windows end where the picture does.
template <class F>
Sums along(int at, int size, F&& value) {
    Sums out;
    for (int i = std::max(0, at - reach); i <= std::min(size - 1, at + reach); ++i) {
        out.add(value(i));
    }
    return out;
}

} // namespace

FlatMeans flat_means(const Picture& before, const Picture& after) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    FlatMeans out{before, after};
    std::vector<double> deviations(before.pixels.size());
    tbb::parallel_for(0, before.height, [&](int y) {
        std::vector<Sums> columns;
        for (int x = 0; x < before.width; ++x) {
            columns.push_back(along(y, before.height, [&](int row) {
                return sums_of(before.at(x, row), after.at(x, row));
            }));
        }
        for (int x = 0; x < before.width; ++x) {
            const Sums sums = along(x, before.width, [&](int column) {
                return columns[static_cast<std::size_t>(column)];
            });
            out.before.at(x, y) = to_float(1 / sums.count * sums.before);
            out.after.at(x, y) = to_float(1 / sums.count * sums.after);
            const double deviation = sums.deviation();
            deviations[static_cast<std::size_t>(y) * static_cast<std::size_t>(before.width) +
                       static_cast<std::size_t>(x)] =
                std::isfinite(deviation) ? deviation : std::numeric_limits<double>::infinity();
        }
    });
    std::vector<double> sorted = deviations;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double limit = std::max(flat, *middle);
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        if (!(deviations[i] <= limit)) {
            out.before.pixels[i] = out.after.pixels[i] = {none, none, none};
        }
    }
    return out;
}

} // namespace lutlib
