#include "lutlib/survey/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lutlib {
namespace {

double cost(double x) {
    return std::isnan(x) ? std::numeric_limits<double>::infinity() : x;
}

template <std::size_t costs>
bool dominates(const std::array<double, costs>& a, const std::array<double, costs>& b) {
    bool better = false;
    for (std::size_t i = 0; i < costs; ++i) {
        if (cost(a[i]) > cost(b[i])) {
            return false;
        }
        better = better || cost(a[i]) < cost(b[i]);
    }
    return better;
}

} // namespace

template <std::size_t costs>
std::vector<std::size_t> dominators(std::span<const std::array<double, costs>> points) {
    // In rising order of the first cost, then of the others, whoever dominates a point comes before
    // it, and one that is not dominated itself is among those kept so far.
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        for (std::size_t i = 0; i < costs; ++i) {
            if (cost(points[a][i]) != cost(points[b][i])) {
                return cost(points[a][i]) < cost(points[b][i]);
            }
        }
        return false;
    });
    std::vector<std::size_t> out(points.size(), not_dominated), front;
    for (const std::size_t point : order) {
        const auto by = std::find_if(front.begin(), front.end(), [&](std::size_t other) {
            return dominates<costs>(points[other], points[point]);
        });
        if (by == front.end()) {
            front.push_back(point);
        } else {
            out[point] = *by;
        }
    }
    return out;
}

template std::vector<std::size_t> dominators<2>(std::span<const std::array<double, 2>>);
template std::vector<std::size_t> dominators<3>(std::span<const std::array<double, 3>>);

} // namespace lutlib
