// How much of its accuracy each method loses as looks grow stiffer, over the suite of stiff looks.
#pragma once

#include "lutlib/metrics/stats.h"
#include "lutlib/survey/stiff_suite.h"
#include "lutlib/survey/survey.h"

#include <vector>

namespace lutlib {

struct StiffRow {
    const StiffLook* look = nullptr;
    int size = 0;
    const Lookup* lookup = nullptr;
    bool fitted = false;
    double stiffness = 0; ///< the look's, in output ranges per width of the domain
    /// Largest channel difference as a share of the look's output range; of its largest magnitude
    /// where it is constant.
    ErrorStats error;
};

struct StiffSurvey {
    std::vector<StiffRow> rows;
    std::size_t colours = 0;
};

/// Each look of the suite, read in double through tetrahedral interpolation, against its resampling
/// in floats at 16 and at 33 nodes, by each lookup; at 16 also
/// fitted.
StiffSurvey survey_stiff_suite(const Progress& progress);

} // namespace lutlib
