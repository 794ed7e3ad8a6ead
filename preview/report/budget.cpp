#include "preview/report/budget.h"

#include <algorithm>

namespace preview::report {

namespace {

/// Leaves the combinations that no other beats, by rising time.
void keep_front(std::vector<Combination>& all) {
    std::stable_sort(all.begin(), all.end(), [](const Combination& a, const Combination& b) {
        return a.seconds != b.seconds ? a.seconds < b.seconds : a.error < b.error;
    });
    std::vector<Combination> front;
    for (Combination& one : all) {
        if (front.empty() || one.error < front.back().error) {
            front.push_back(std::move(one));
        }
    }
    all = std::move(front);
}

} // namespace

std::vector<Combination> combination_front(std::span<const std::vector<ChoiceOption>> passes) {
    std::vector<Combination> front(1);
    for (const std::vector<ChoiceOption>& options : passes) {
        std::vector<Combination> all;
        for (const Combination& combination : front) {
            for (std::size_t i = 0; i < options.size(); ++i) {
                Combination next = combination;
                next.options.push_back(i);
                next.seconds += options[i].seconds;
                next.error += options[i].error;
                all.push_back(std::move(next));
            }
        }
        keep_front(all);
        front = std::move(all);
    }
    return front;
}

const Combination* within_budget(std::span<const Combination> front, double seconds) {
    const Combination* out = nullptr;
    for (const Combination& one : front) {
        out = one.seconds <= seconds ? &one : out;
    }
    return out;
}

} // namespace preview::report
