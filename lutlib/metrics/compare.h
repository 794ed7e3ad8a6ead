// How far apart two transforms are, in code values and to the eye, and where most.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/lut.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/transform.h"

#include <vector>

namespace lutlib {

/// One input and what both transforms make of it.
struct WorstColour {
    Rgb in;
    RgbD a, b;
};

struct Difference {
    ErrorStats absolute; ///< per colour, the largest channel difference, in code values
    ErrorStats delta_e_2000;
    ErrorStats delta_e_itp;
    double psnr = 0;   ///< decibels, of all channels, for a peak of 1; +Inf when all are equal
    WorstColour worst; ///< by absolute difference
    WorstColour worst_to_eye; ///< by dE2000
};

/// Over the given inputs. `output` says what the results' code values are, which the colour
/// differences need; light of 1 is 100 cd/m2.
Difference compare(const Transform& a, const Transform& b, const std::vector<Rgb>& inputs,
                   const Encoding& output);

/// The same of results that are there already: a[i] and b[i] are what inputs[i] became.
Difference difference_of(const std::vector<Rgb>& inputs, const std::vector<RgbD>& a,
                         const std::vector<RgbD>& b, const Encoding& output);

/// sample_colors() over a domain: its corners, its neutral axis, the nodes and cell centres of a
/// lattice, and points spread evenly.
std::vector<Rgb> samples_over(const Domain& domain, int lattice_size, int random_count = 100000);

} // namespace lutlib
