// The stability of a look: what in it is broken, folded, steep or flat, where that sits, and what
// it does to a picture.
//
// Steepness is counted per width of the look's input domain, so that 0..1 and 0..4 compare: a gain
// of 2 moves an output channel by 2 while the input crosses its whole domain. Where there is a
// shaper, it is part of the figure. Places are inputs of the look. Values that are not finite are
// counted, and left out of every other figure.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/lut.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/transform.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

/// A figure and the input where it is found.
struct Extreme {
    double value = 0;
    Rgb in;
};

/// Of many figures: the median, and what one in a hundred exceeds.
struct Spread {
    double p50 = 0, p99 = 0;
};

/// What a lattice of `nodes` a side over the look's domain, without a shaper, holding the look's
/// values at its nodes and read tetrahedrally, misses of the look, as measure() finds it.
struct LatticeError {
    int nodes = 0;
    bool measured = false;   ///< false: the look holds values that are no numbers
    ErrorStats code, to_eye; ///< the largest channel difference; dE2000, of HDR dE-ITP
    Rgb in;                  ///< of the largest
};

/// What a look's results are for, as their encoding says.
enum class Results {
    display, ///< codes of a display of 0..1, or not known
    hdr,     ///< codes of PQ or HLG
    scene,   ///< light, or a camera's log: nobody looks at these codes
};

/// The stored numbers, three for each node and entry.
struct StoredValues {
    std::size_t values = 0;
    std::size_t non_finite = 0;
    std::optional<Rgb> first_non_finite;
    std::size_t outside = 0; ///< finite values below 0 or above 1 in the output
    Extreme lowest, highest; ///< of the output
};

/// The six tetrahedra of every cell that an input can reach, and the sign of the Jacobian's
/// determinant in each. Flat: too small to have a sign beside the rounding of six decimals.
struct CellHealth {
    std::size_t tetrahedra = 0;
    std::size_t flat = 0;
    std::size_t folded = 0; ///< of the rarer sign
    bool mirrored = false; ///< the commoner sign is negative: two channels swapped, or one inverted
    Extreme deepest_fold;  ///< determinant of the worst folded tetrahedron, against the sign
    double invertible = 0; ///< share of the input's volume that is neither flat nor folded

    Extreme gain;      ///< largest singular value of the Jacobian
    Extreme condition; ///< largest ratio of singular values where not flat
    /// The same of all tetrahedra, or of every k-th of a large look.
    Spread gain_spread, condition_spread;
    Extreme banding_channel; ///< output codes between neighbouring input codes of one channel
};

/// Where the tables bend, and where an output channel stands still. Shares of the cells or of the
/// curve's segments; a place is where it begins.
struct TableHealth {
    Extreme second_difference; ///< between neighbouring nodes along an axis, in output units
    std::array<Extreme, 3> clipped_low, clipped_high; ///< at the lowest, the highest value
    Extreme plateau; ///< a channel constant between its extremes, along every axis
};

/// The 1D table before a cube, or alone.
struct ShaperHealth {
    std::size_t cut_off = 0;            ///< finite values that the cube's domain cuts off
    std::array<Extreme, 3> shaper_fall; ///< largest fall between neighbouring entries, >= 0
};

/// Along the neutral axis, from the domain's minimum to its maximum.
struct NeutralHealth {
    Extreme neutral_fall;                ///< largest fall of Rec.709 luma from its highest so far
    std::array<Extreme, 3> channel_fall; ///< the same of each channel
    double neutral_rise = 0;             ///< luma at the end less luma at the start
    int ramp_bits = 8; ///< of the ramp below: 8 where the look takes a display's codes, else 10
    Extreme banding_neutral; ///< output codes between neighbouring input codes of a neutral ramp
    Extreme banding_to_eye;  ///< the same in dE2000, of HDR in dE-ITP; of scenes nothing
};

/// Values of single nodes that stand out of all lines through them by far more than those beside
/// bend: what the repair of spikes would level.
struct SpikesExamined {
    std::size_t spikes = 0;
    Extreme largest_spike; ///< how far it stands out
};

/// All that is found out about a look, each part by its own examiner.
struct Health : StoredValues, SpikesExamined, CellHealth, TableHealth, ShaperHealth, NeutralHealth {
    Extreme noise_gain; ///< of white noise, in the darkest sixteenth of the neutral axis
    Results results = Results::display;
    std::array<LatticeError, 2> lattices; ///< of 16 and 33 nodes
};

struct ExamineOptions {
    /// What the look is a table of, such as a recipe: its lattices are measured against it.
    std::optional<Transform> exact{};
    /// In place of what the look says of its codes; sRGB where neither does.
    LookEncodings encodings{};
    bool lattices = true; ///< whether Health::lattices is measured, which takes longest
};

/// Everything above. The look may hold values that are not finite; else it must be valid.
Health examine(const Lut& lut, const ExamineOptions& options = {});

enum class Severity { good, note, warning, fault };
std::string_view name_of(Severity severity);

/// One point of the verdict.
struct Finding {
    Severity severity = Severity::good;
    double figure = 0;
    std::string words;
    std::optional<Rgb> where;
};

/// One row: what is looked at, and what a look's figures say about it.
struct HealthCheck {
    std::string_view name;
    std::string_view unit;
    std::string_view help;
    Finding (*judge)(const Health& health);
};

/// Every check, in the order of the report.
std::span<const HealthCheck> health_checks();

/// The worst severity of all checks. A look with a fault is unhealthy.
Severity verdict(const Health& health);

} // namespace lutlib
