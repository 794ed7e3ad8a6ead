#include "lutlib/survey/timing.h"

#include <sys/utsname.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>
#include <vector>

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

} // namespace

double now_seconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

Timing measure(const std::function<void()>& run, int repetitions) {
    run();
    std::vector<double> seconds;
    for (int i = 0; i < repetitions; ++i) {
        const double start = now_seconds();
        run();
        seconds.push_back(now_seconds() - start);
    }
    std::sort(seconds.begin(), seconds.end());
    const auto at = [&](double share) {
        return seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1) +
                                                0.5)];
    };
    return {at(0.5), at(0.25), at(0.75), repetitions};
}

std::string machine_text() {
    utsname system{};
    uname(&system);
    const unsigned cores = std::thread::hardware_concurrency();
    return processor() + ", " + std::to_string(cores) + (cores == 1 ? " core, " : " cores, ") +
           system.sysname + " " + system.release + ", " + compiler();
}

} // namespace lutlib
