// How fast each way of reading a lattice nears stiff and extreme looks as its cells grow small, and
// how far it stays from them.
#pragma once

#include "lutlib/interpolation/stored_lut.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/survey/slope.h"
#include "lutlib/survey/stiff_function.h"
#include "lutlib/survey/survey.h"

#include <span>
#include <string_view>
#include <vector>

namespace lutlib {

/// One way of keeping and reading a lattice.
struct StiffMethod {
    std::string_view name, label;
    const Lookup* lookup = nullptr; ///< null: tricubic, in double
    const Storage* storage = nullptr;
    bool shaper = false; ///< nodes evenly spaced in sRGB's codes of the input taken for light
    bool fitted = false;
};
/// nearest, trilinear, tetrahedral and tricubic in floats; tetrahedral in 8, 10 and 16 bits, behind
/// a shaper, and fitted.
std::span<const StiffMethod> stiff_methods();

/// Over the phases: the mean of each figure, and the worst.
struct StiffFigures {
    double p99 = 0, mean = 0, max = 0;
};
struct StiffPoint {
    int size = 0;
    StiffFigures average, worst;
    double bound = 0; ///< of the largest error, before anything is measured; 0: none is known
};

struct StiffCurve {
    const StiffProfile* profile = nullptr;
    StiffAxis axis = StiffAxis::channel;
    const StiffMethod* method = nullptr;
    std::vector<StiffPoint> points; ///< by rising size
    Slope largest; ///< the exponent of the worst largest error in the width of a cell
    Slope mean;    ///< of the average mean error
};

struct StiffSettings {
    std::vector<int> sizes{8, 12, 16, 24, 33, 48, 65};
    int phases = 16;   ///< places of the feature within a cell, evenly spaced
    int colors = 1024; ///< spread evenly; as many again around the feature, for the largest alone
    /// What needs whole lattices goes no further, and through fewer phases.
    int largest_fitted = 16, largest_tricubic = 33;
    int whole_phases = 4;
};

struct StiffSurvey {
    StiffSettings settings;
    std::vector<StiffCurve> curves;
};

/// Errors are the largest channel difference from the function itself, in double.
StiffSurvey survey_stiff_suite(const StiffSettings& settings, const Progress& progress);

} // namespace lutlib
