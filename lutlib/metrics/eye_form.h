// How much the eye sees of a small error of a colour's codes.
#pragma once

#include "lutlib/metrics/viewing.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lutlib {

/// The square of the difference that the eye sees, as a quadratic form of a code error: J^T J of
/// the Jacobian J of a space that is uniform around the colour. dE2000 of displays, dE-ITP of HDR.
struct EyeForm {
    float rr = 0, gg = 0, bb = 0, rg = 0, rb = 0, gb = 0;

    /// Of an error in code values.
    float length(const Rgb& e) const {
        const float square = rr * e.r * e.r + gg * e.g * e.g + bb * e.b * e.b +
                             2 * (rg * e.r * e.g + rb * e.r * e.b + gb * e.g * e.b);
        return std::sqrt(square > 0 ? square : 0);
    }
    /// The most that is seen of an error of 1 in every channel.
    float most() const {
        return std::max(
            {length({1, 1, 1}), length({1, 1, -1}), length({1, -1, 1}), length({-1, 1, 1})});
    }
    /// The square that an error of one channel alone gets, for an error of 1.
    float of_channel(std::size_t channel) const {
        return channel == 0 ? rr : channel == 1 ? gg : bb;
    }
};

/// The metric whose form that is.
Metric eye_metric(const Viewing& viewing);

/// Around each colour, from differences of half a code of 8 bits.
std::vector<EyeForm> eye_forms(const std::vector<RgbD>& codes, const Viewing& viewing);

} // namespace lutlib
