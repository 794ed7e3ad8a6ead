// Numbers of a picture's file that are no light: how many there are, and what is made of them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace preview {

/// Pixels, each in as many counts as it has such numbers in its colour.
struct OddPixels {
    std::size_t with_nan = 0, with_infinity = 0, with_negative = 0;
    friend bool operator==(const OddPixels&, const OddPixels&) = default;
};

/// In RGBA, before anything is calculated with it, for one channel that is not finite spoils all
/// three of a conversion: NaN becomes 0, and so does minus infinity, infinity the largest half.
/// Finite numbers below 0 stay: in another gamut they may be light.
OddPixels settle_odd_numbers(std::span<float> rgba);

/// A sentence each, about the file.
std::vector<std::string> told_of(const OddPixels& odd);

} // namespace preview
