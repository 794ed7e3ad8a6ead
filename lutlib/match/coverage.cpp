#include "lutlib/match/coverage.h"

#include "lutlib/nodes.h"

#include <algorithm>
#include <limits>

namespace lutlib {
namespace {

// A pixel in the middle of a cell has a quarter of its weight at each node that is read, and the
// square of it in the support.
constexpr double least_said = 1 / 16.0;
constexpr int nearby = 2;
constexpr int farthest = std::numeric_limits<int>::max();

constexpr std::array<std::string_view, 8> corner_names{"black", "red",     "green", "yellow",
                                                       "blue",  "magenta", "cyan",  "white"};

// From the supported nodes outwards.
void spread(std::vector<int>& steps, int size) {
    const auto n = static_cast<std::size_t>(size);
    std::vector<std::size_t> front;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (steps[k] == 0) {
            front.push_back(k);
        }
    }
    while (!front.empty()) {
        std::vector<std::size_t> next;
        for (const std::size_t k : front) {
            const auto r = static_cast<int>(k % n), g = static_cast<int>(k / n % n),
                       b = static_cast<int>(k / n / n);
            for (int step = 0; step < 27; ++step) {
                const int to_r = r + step % 3 - 1, to_g = g + step / 3 % 3 - 1,
                          to_b = b + step / 9 - 1;
                if (std::min({to_r, to_g, to_b}) < 0 || std::max({to_r, to_g, to_b}) >= size) {
                    continue;
                }
                const std::size_t to =
                    static_cast<std::size_t>(to_r) +
                    n * (static_cast<std::size_t>(to_g) + n * static_cast<std::size_t>(to_b));
                if (steps[to] == farthest) {
                    steps[to] = steps[k] + 1;
                    next.push_back(to);
                }
            }
        }
        front = std::move(next);
    }
}

} // namespace

Coverage coverage_of(std::span<const double> support, int size) {
    Coverage out;
    out.size = size;
    out.steps.assign(support.size(), farthest);
    const auto nodes = static_cast<double>(support.size());
    std::array<double, 8> all{}, said{};
    std::size_t k = 0;
    for_each_node(size, [&](int r, int g, int b) {
        const auto upper = [size](int i) { return 2 * i >= size ? 1U : 0U; };
        const std::size_t corner = upper(r) + 2 * upper(g) + 4 * upper(b);
        const bool is_supported = support[k] >= least_said;
        ++all[corner];
        if (is_supported) {
            ++said[corner];
            out.supported += 1 / nodes;
            out.steps[k] = 0;
            if (r == g && g == b) {
                const double grey = static_cast<double>(r) / (size - 1);
                out.greys = out.greys ? std::array{(*out.greys)[0], grey} : std::array{grey, grey};
            }
        }
        ++k;
    });
    spread(out.steps, size);
    for (const int steps : out.steps) {
        out.near += steps <= nearby ? 1 / nodes : 0;
    }
    for (std::size_t i = 0; i < out.corners.size(); ++i) {
        out.corners[i] = {corner_names[i], all[i] > 0 ? said[i] / all[i] : 0};
    }
    return out;
}

} // namespace lutlib
