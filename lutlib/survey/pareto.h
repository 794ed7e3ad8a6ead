// Which of many choices are worth having: those that no other beats in everything that costs.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace lutlib {

/// No member of the set is at least as good as another in every cost and better in one.
inline constexpr std::size_t not_dominated = static_cast<std::size_t>(-1);

/// For each point of costs the index of one that dominates it, itself not dominated, or
/// not_dominated. Equal points do not dominate each other. A NaN cost is the highest.
template <std::size_t costs>
std::vector<std::size_t> dominators(std::span<const std::array<double, costs>> points);

extern template std::vector<std::size_t> dominators<2>(std::span<const std::array<double, 2>>);
extern template std::vector<std::size_t> dominators<3>(std::span<const std::array<double, 3>>);

} // namespace lutlib
