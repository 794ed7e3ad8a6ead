// What examine() is made of: each examiner returns its part of Health.
#pragma once

#include "lutlib/health/health.h"

namespace lutlib::health {

/// The size of the rounding in which the look's numbers were stored: half a code where all of them
/// are codes of 8, 10 or 12 bits, else the last of six decimals, else the last bit of tiny values.
double rounding_of(const Lut& lut);

/// A fall of neutrals' luma: half a code of 8 bits, which is seen, and two, which are a fault.
inline constexpr double fall_warning = 0.5 / 255, fall_fault = 2.0 / 255;

/// Part of the whole; 0 where that is nothing.
inline double share(std::size_t part, std::size_t whole) {
    return whole ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

/// Whole colours of finite values.
bool finite(const Rgb& c);

StoredValues examine_values(const Lut& lut);
SpikesExamined examine_spikes(const Lut& lut);

struct CellsExamined {
    CellHealth cells;
    TableHealth table;
};
/// `cube` is the look's own, or the identity over its curve's outputs where it has none.
CellsExamined examine_cells(const Lut& lut, const Lut3D& cube, double rounding);

struct CurveExamined {
    ShaperHealth shaper;
    TableHealth table; ///< of a curve before a cube the plateau alone
};
/// `cube` is what follows the curve, or null.
CurveExamined examine_curve(const Lut1D& curve, const Lut3D* cube, double rounding);

/// What the look takes and gives, sRGB where nobody says.
struct Codes {
    Encoding input = srgb(), output = srgb();
    Results results = Results::display;
    bool display_input = true;
};
Codes codes_of(const Lut& lut, const LookEncodings& stated);

NeutralHealth examine_neutrals(const Lut& lut, const Codes& codes, double rounding);

/// Health::noise_gain.
Extreme examine_black(const Lut& lut);

/// Of lattices of 16 and 33 nodes, against `exact`.
std::array<LatticeError, 2> measure_lattices(const Lut& lut, const Transform& exact,
                                             const Codes& codes);

} // namespace lutlib::health
