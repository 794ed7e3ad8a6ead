// How long things take, with the interval of each figure, and on what machine.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace lutlib {

/// Seconds of one run, over repetitions.
struct Timing {
    double median = 0;
    /// Of the median: it lies between them with a probability of 95 % or more.
    double low = 0, high = 0;
    double best = 0; ///< the least of all
    int repetitions = 0;

    /// Of one of `count` equal parts of the run.
    Timing shared_by(std::size_t count) const;
};

/// Of the seconds that runs took, one or more. The interval is that of order statistics, which
/// holds for every distribution: the ranks k and n+1-k with the largest k for which the binomial
/// probability of fewer than k of n runs below the true median is at most 2.5 % (David and
/// Nagaraja, "Order Statistics", 2003, section 7.1). Below six runs there is no such k: least and
/// largest.
Timing timing_of(std::vector<double> seconds);

/// Times every run once in each round, so that what slows the machine down for a while slows all of
/// them. Each is run once untimed just before, since another has filled the caches.
/// `progress` gets the share of the rounds that are done.
std::vector<Timing> measure_interleaved(std::span<const std::function<void()>> runs, int rounds,
                                        const std::function<void(double share)>& progress);

/// Seconds since an arbitrary moment.
double now_seconds();

/// "AMD EPYC 7R13, 2 cores, Linux 6.1, GCC 12.2": what a measured time depends on.
std::string machine_text();

} // namespace lutlib
