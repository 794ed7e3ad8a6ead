// What precision does to a look: of storage and arithmetic, of its input, and of what lies between
// several looks.
#pragma once

#include "lutlib/metrics/stats.h"

#include <string>
#include <vector>

namespace lutlib {

/// Nodes a side of the lattices here; no shaper.
inline constexpr int precision_size = 33;

/// Reading one lattice, against the same in double from nodes in double.
struct PrecisionRow {
    std::string storage, arithmetic, lookup;
    ErrorStats ulp; ///< in last places of a float of the exact result, of 2^-10 at least
    ErrorStats delta_e;
};

/// What half a code more or less in each channel of the input does to the exact look: of the eight
/// ways the worst, over evenly spread colours.
struct SensitivityRow {
    int bits = 0; ///< of the input's codes over the domain
    double p50 = 0;
    ErrorStats delta_e;
};

/// A camera whose pixels hold so many electrons at light 1, with Gaussian read noise: the variance
/// in electrons is the signal (shot noise) and the square of the read noise (EMVA 1288,
/// release 4.0, section 2.2, without dark current and quantisation).
inline constexpr double camera_electrons = 30'000, camera_read_noise = 5;
/// One grey through the exact look.
struct NoiseRow {
    double light = 0;   ///< of a grey
    double in = 0;      ///< standard deviation of the input's codes, a channel, of 0..1
    double out = 0;     ///< of the result's, the noisiest channel
    double gain = 0;    ///< out / in
    double delta_e = 0; ///< mean, of noisy against clean
};

/// Tetrahedral lattices in floats.
struct ChainRow {
    std::string what;    ///< "2 looks in turn", "2 looks as one lattice", "look and inverse"
    std::string between; ///< what results are kept in on the way
    ErrorStats delta_e;  ///< against the exact looks in turn; the inverse: against the input
};

struct Strain {
    std::vector<PrecisionRow> precision;
    std::vector<SensitivityRow> sensitivity;
    std::vector<NoiseRow> noise;  ///< empty where no light is positive
    std::vector<ChainRow> chains; ///< empty for a look whose results it does not take itself
};

} // namespace lutlib
