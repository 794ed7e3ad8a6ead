#include "lutlib/rising.h"

#include <cstddef>

namespace lutlib {

std::vector<double> rising(const std::vector<double>& values) {
    return rising(values, std::vector<double>(values.size(), 1));
}

std::vector<double> rising(const std::vector<double>& values, const std::vector<double>& weights) {
    struct Pool {
        double sum, weight;
        std::size_t count;
        double mean() const { return sum / weight; }
    };
    std::vector<Pool> pools;
    for (std::size_t i = 0; i < values.size(); ++i) {
        pools.push_back({values[i] * weights[i], weights[i], 1});
        while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
            const Pool top = pools.back();
            pools.pop_back();
            pools.back().sum += top.sum;
            pools.back().weight += top.weight;
            pools.back().count += top.count;
        }
    }
    std::vector<double> out;
    for (const Pool& pool : pools) {
        out.insert(out.end(), pool.count, pool.mean());
    }
    return out;
}

} // namespace lutlib
