// The colour of one place of the picture, before the looks and after each side's.
#pragma once

#include "lutlib/rgb.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace preview {

struct ProbePlace {
    std::int32_t x = 0, y = 0; ///< a texel of the picture, from its upper left
    friend bool operator==(const ProbePlace&, const ProbePlace&) = default;
};

/// Display-encoded, and not clamped: a look in float may leave 0..1.
struct Probe {
    lutlib::RgbD before, a, b;
    lutlib::RgbD light; ///< scene light before the tone map, exposed; 0 where there is none
    /// Bit by bit: NaN, which a broken look may give, equals itself.
    friend bool operator==(const Probe& a, const Probe& b);
};

/// From what the probe pass wrote; empty for anything else.
std::optional<Probe> probe_from(std::span<const std::byte> bytes);

/// What 8 bits hold of a colour; NaN is 0.
struct Codes {
    int r = 0, g = 0, b = 0;
};
Codes codes_of(lutlib::RgbD color);

/// dE2000 as a display shows them, that is of colours clamped to 0..1.
struct ProbeDifferences {
    double before_a = 0, before_b = 0, a_b = 0;
};
ProbeDifferences differences_of(const Probe& probe);

/// A line for each colour with its codes, its values and its difference from the one before.
std::string probe_table(const Probe& probe, ProbePlace place);
std::string probe_json(const Probe& probe, ProbePlace place);

} // namespace preview
