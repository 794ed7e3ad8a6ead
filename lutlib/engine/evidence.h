// What the nodes of a lattice say about whether they were read in the right places: a look is
// smooth, keeps greys nearly grey, and turns the circle of hues without mirroring it.
#pragma once

#include "lutlib/lut.h"

#include <array>

namespace lutlib {

/// Of Evidence::tone: nearer to 0 is neither brighter nor darker.
inline constexpr double tone_slack = 0.02;

struct Evidence {
    /// The mean squared step between neighbours against that between nodes taken at random: near 0
    /// for a smooth lattice, 1 for a shuffled one (von Neumann's ratio, halved). Of the roughest of
    /// the three axes. 1 for a lattice of one colour.
    double roughness = 1;
    /// The mean squared step between neighbours, summed over channels, along all axes.
    double step = 0;
    /// Of the linear map that comes nearest to the look: how fast greys gain colour along the grey
    /// axis, against how fast colours gain it across; 0 where greys stay grey.
    double grey_drift = 0;
    /// The determinant of that map on the plane across the grey axis against its squared size: 1
    /// where hues keep their order (however far they are turned), -1 where they are mirrored, near
    /// 0 where they collapse.
    double hue_order = 0;
    /// The size of the map across the grey axis against its whole: 0 for a look without colour.
    double color = 0;
    /// How much each channel follows its own axis rather than others, -1..1; 1 for an identity.
    double ownership = 0;
    /// How fast the mean of the channels grows along each axis, of the largest of them: -1..1.
    std::array<double, 3> tone{};
};

Evidence evidence_of(const Lut3D& cube);

/// Whether it grows darker along all three axes, as a negative does.
bool falls(const Evidence& evidence);

} // namespace lutlib
