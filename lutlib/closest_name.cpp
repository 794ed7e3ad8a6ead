#include "lutlib/closest_name.h"

#include "lutlib/text.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace lutlib {
namespace {

// Letters put in, left out, replaced or swapped with their neighbour that turn one word into the
// other (optimal string alignment), capitals aside.
std::size_t edits_between(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) {
        last[j] = j;
    }
    const auto same = [&](std::size_t i, std::size_t j) {
        return upper(a[i - 1]) == upper(b[j - 1]);
    };
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same(i, j) ? 0U : 1U)});
            if (i > 1 && j > 1 && same(i, j - 1) && same(i - 1, j)) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        before = std::exchange(last, row);
    }
    return last[b.size()];
}

} // namespace

std::string_view closest_name(std::string_view name, std::span<const std::string_view> names) {
    constexpr std::size_t short_name = 3, longest_name = 64;
    if (name.size() > longest_name) {
        return {};
    }
    std::size_t fewest = name.size() <= short_name ? 2 : 3;
    std::string_view best;
    for (const std::string_view candidate : names) {
        const std::size_t edits = edits_between(name, candidate);
        if (edits < std::min(fewest, candidate.size())) {
            fewest = edits;
            best = candidate;
        }
    }
    return best;
}

} // namespace lutlib
