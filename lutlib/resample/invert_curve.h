// The inverse of a 1D table, channel by channel.
//
// A table is straight between its entries, so its inverse is exactly known: straight between their
// values. What has none is made monotone first, by the running extreme from the low end: where the
// table turns back, the inverse takes the input that it reached first. Of inputs that give one
// value (a flat part) it takes the nearest to the value itself, so that a clipped white stays
// white.
#pragma once

#include "lutlib/lut.h"

#include <array>
#include <optional>

namespace lutlib {

struct CurveInversion {
    struct Channel {
        /// Units of input over which the table stands still: the inverse has one input for each.
        double flat = 0;
        /// Units of input over which it turns back, and by how much of its values at most.
        double turned = 0, depth = 0;
        /// Inputs a unit of value, beside the inverse's low and its high end. Beyond its ends the
        /// inverse is held, as every table is.
        double slope_low = 0, slope_high = 0;
    };
    std::array<Channel, 3> channels;
    Lut1D curve;
};

struct InvertCurveOptions {
    std::optional<int> size;      ///< entries; default: as many as 1e-6 of the inputs needs
    std::optional<Domain> domain; ///< default: the values that the table takes
};

/// Throws Error for a channel that begins and ends at one value: it has no inverse.
CurveInversion invert_curve(const Lut1D& curve, const InvertCurveOptions& options = {});

/// The input at which a channel of a table that rises or falls strictly gives `y`, held to its
/// ends.
double inverse_of_curve(const Lut1D& curve, double y, std::size_t channel);
/// Throws Error for a table that does not rise or fall strictly in every channel.
void check_invertible(const Lut1D& curve);

} // namespace lutlib
