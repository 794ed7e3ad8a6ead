// What a process that reads strangers' files may do: compute, within limits. Nothing else.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lutlib::io::box {

struct Allowance {
    std::size_t memory = std::size_t{4} << 30; ///< bytes of address space
    std::vector<std::string> readable;         ///< files and folders, with all below
};

/// Which of the system's ways hold the process, as --version --verbose shows them.
struct Held {
    int landlock = 0; ///< version of its interface; 0: the system has none
    bool seccomp = false;
};

/// For good: limits on memory and open files, no core dumps; by Landlock no file but those to be
/// read, by seccomp no network, no program, no change to files. What the system lacks is left out
/// and not told among `Held`.
Held confine(const Allowance& allowance);

/// What confine() does in the same way for all processes that come of this one, beforehand.
void prepare_to_confine();

/// Ends the process (SIGXCPU) when it computes for so many seconds from now on.
void limit_computing(unsigned seconds);

} // namespace lutlib::io::box
