// Pixels of a picture as people take them: few colours of the cube, some of them often.
#pragma once

#include "lutlib/codes.h"
#include "lutlib/match/color_bins.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace lutlib {

/// Muted colours about a grey axis, rounded to 8 bits, through `look`, rounded again.
template <class F>
std::vector<PixelPair> picture_pairs(F look, int count) {
    const CodeDepth depth{8};
    std::vector<PixelPair> out;
    std::uint32_t state = 1;
    const auto next = [&state] {
        state = state * 1664525 + 1013904223;
        return static_cast<double>(state >> 8) / (1 << 24);
    };
    for (int i = 0; i < count; ++i) {
        const double grey = next(), a = 0.3 * (next() - 0.5), b = 0.3 * (next() - 0.5);
        RgbD before{grey + a, grey, grey + b};
        RgbD after;
        for (std::size_t c = 0; c < 3; ++c) {
            before[c] = depth.rounded(before[c]);
        }
        after = look(before);
        for (std::size_t c = 0; c < 3; ++c) {
            after[c] = depth.rounded(after[c]);
        }
        out.push_back({to_float(before), to_float(after)});
    }
    return out;
}

} // namespace lutlib
