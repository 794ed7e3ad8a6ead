// How long something takes, with its spread, and on what machine.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace lutlib {

/// Seconds of one run, over repetitions after a warming one.
struct Timing {
    double median = 0;
    double lower_quartile = 0, upper_quartile = 0;
    int repetitions = 0;
};

Timing measure(const std::function<void()>& run, int repetitions);

/// Seconds since an arbitrary moment.
double now_seconds();

/// "AMD EPYC 7R13, 2 cores, Linux 6.1, GCC 12.2": what a measured time depends on.
std::string machine_text();

} // namespace lutlib
