// How far apart two transforms are, in code values and to the eye, and where most.
#pragma once

#include "lutlib/lut.h"
#include "lutlib/metrics/climb.h"
#include "lutlib/metrics/error_samples.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/metrics/viewing.h"
#include "lutlib/transform.h"

#include <vector>

namespace lutlib {

/// One input and what both transforms make of it.
struct WorstColor {
    Rgb in;
    RgbD a, b;
};

struct Difference {
    ErrorStats absolute; ///< per colour, the largest channel difference, in code values
    ErrorStats delta_e_2000;
    ErrorStats delta_e_itp;
    double psnr = 0;  ///< decibels, of all channels, for a peak of 1; +Inf when all are equal
    WorstColor worst; ///< by absolute difference
    WorstColor worst_to_eye; ///< by dE2000
    WorstColor worst_to_itp; ///< by dE-ITP

    const ErrorStats& by(Metric metric) const {
        return metric == Metric::code           ? absolute
               : metric == Metric::delta_e_2000 ? delta_e_2000
                                                : delta_e_itp;
    }
};

/// What every verb prints. Means and percentiles are over samples.even. Maxima are over all of the
/// samples and uphill from the worst of them by each metric; `largest_seen` is set where the
/// samples are not whole.
Difference measure(const Transform& a, const Transform& b, const ErrorSamples& samples,
                   const Viewing& viewing);

/// The same maximum by one metric.
Peak largest_difference(const Transform& a, const Transform& b, const ErrorSamples& samples,
                        const Viewing& viewing, Metric metric);

/// Over the given inputs alone, maxima too.
Difference compare(const Transform& a, const Transform& b, const std::vector<Rgb>& inputs,
                   const Viewing& viewing);

/// The same of results that are there already: a[i] and b[i] are what inputs[i] became.
Difference difference_of(const std::vector<Rgb>& inputs, const std::vector<RgbD>& a,
                         const std::vector<RgbD>& b, const Viewing& viewing);

/// sample_colors() over a domain: its corners, its neutral axis, the nodes and cell centres of a
/// lattice, and points spread evenly.
std::vector<Rgb> samples_over(const Domain& domain, int lattice_size, int random_count = 100000);

} // namespace lutlib
