#include "lutlib/survey/timing.h"

#include <sys/utsname.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>
#include <utility>

namespace lutlib {
namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const std::size_t colon = line.find(':');
        if (line.rfind("model name", 0) == 0 && colon != std::string::npos) {
            return line.substr(std::min(colon + 2, line.size()));
        }
    }
    return "unknown processor";
}

std::string compiler() {
#if defined(__clang__)
    return "clang " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__);
#else
    return "GCC " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__);
#endif
}

// The largest rank, from 1, whose order statistic and its mirror image enclose the median with at
// least 95 %.
std::size_t interval_rank(std::size_t n) {
    constexpr double tail = 0.025;
    double probability =
        std::pow(0.5, static_cast<double>(n)); // of exactly k of n below the median
    double below = 0;                          // of fewer than k
    std::size_t k = 0;
    while (k < n / 2 && below + probability <= tail) {
        below += probability;
        ++k;
        probability *= static_cast<double>(n - k + 1) / static_cast<double>(k);
    }
    return std::max(k, std::size_t{1});
}

} // namespace

double now_seconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

Timing Timing::shared_by(std::size_t count) const {
    const auto parts = static_cast<double>(count);
    return {median / parts, low / parts, high / parts, best / parts, repetitions};
}

Timing timing_of(std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    const std::size_t n = seconds.size();
    const std::size_t rank = interval_rank(n);
    return {(seconds[(n - 1) / 2] + seconds[n / 2]) / 2, seconds[rank - 1], seconds[n - rank],
            seconds.front(), static_cast<int>(n)};
}

std::vector<Timing> measure_interleaved(std::span<const std::function<void()>> runs, int rounds,
                                        const std::function<void(double share)>& progress) {
    std::vector<std::vector<double>> seconds(runs.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < runs.size(); ++i) {
            runs[i]();
            const double start = now_seconds();
            runs[i]();
            seconds[i].push_back(now_seconds() - start);
        }
        progress(static_cast<double>(round + 1) / rounds);
    }
    std::vector<Timing> out;
    out.reserve(runs.size());
    for (std::vector<double>& each : seconds) {
        out.push_back(timing_of(std::move(each)));
    }
    return out;
}

std::string machine_text() {
    utsname system{};
    uname(&system);
    const unsigned cores = std::thread::hardware_concurrency();
    return processor() + ", " + std::to_string(cores) + (cores == 1 ? " core, " : " cores, ") +
           system.sysname + " " + system.release + ", " + compiler();
}

} // namespace lutlib
