#include "lutlib/rising.h"

#include <cstddef>

namespace lutlib {

std::vector<double> rising(const std::vector<double>& values) {
    struct Pool {
        double sum;
        std::size_t count;
        double mean() const { return sum / static_cast<double>(count); }
    };
    std::vector<Pool> pools;
    for (const double v : values) {
        pools.push_back({v, 1});
        while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
            const Pool top = pools.back();
            pools.pop_back();
            pools.back().sum += top.sum;
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
