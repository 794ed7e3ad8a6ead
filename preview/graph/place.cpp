#include "preview/graph/plan.h"

#include <algorithm>
#include <numeric>

namespace preview {

Placement place(std::span<const Lifetime> lifetimes, std::span<const Extent> extents) {
    Placement placement;
    placement.offsets.assign(lifetimes.size(), 0);
    std::vector<std::size_t> order(lifetimes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return extents[a].size > extents[b].size;
    });
    std::vector<std::size_t> placed;
    for (const std::size_t index : order) {
        std::vector<std::size_t> rivals;
        for (const std::size_t other : placed) {
            if (lifetimes[other].first <= lifetimes[index].last &&
                lifetimes[index].first <= lifetimes[other].last) {
                rivals.push_back(other);
            }
        }
        std::sort(rivals.begin(), rivals.end(), [&](std::size_t a, std::size_t b) {
            return placement.offsets[a] < placement.offsets[b];
        });
        const std::uint64_t alignment = extents[index].alignment;
        std::uint64_t offset = 0;
        for (const std::size_t rival : rivals) {
            if (offset + extents[index].size <= placement.offsets[rival]) {
                break;
            }
            const std::uint64_t end = placement.offsets[rival] + extents[rival].size;
            offset = std::max(offset, (end + alignment - 1) / alignment * alignment);
        }
        placement.offsets[index] = offset;
        placement.bytes = std::max(placement.bytes, offset + extents[index].size);
        placed.push_back(index);
    }
    return placement;
}

} // namespace preview
