// The kernel under Python's apply() (python_apply): apply_bench LOOK WIDTH HEIGHT ROUNDS THREADS
// prints the least milliseconds of one pass over float RGB of WIDTH x HEIGHT.
#include "lutlib/interpolation/grade.h"
#include "lutlib/io/look.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

int main(int argc, char** argv) {
    if (argc != 6) {
        std::fputs("apply_bench LOOK WIDTH HEIGHT ROUNDS THREADS\n", stderr);
        return 3;
    }
    const lutlib::Grading look(*lutlib::io::Look::open(argv[1]).table().lut);
    const auto width = static_cast<std::size_t>(std::atoll(argv[2]));
    const auto height = static_cast<std::size_t>(std::atoll(argv[3]));
    std::vector<float> in(width * height * 3), out(in.size());
    for (std::size_t i = 0; i < in.size(); ++i) {
        in[i] = static_cast<float>(i * 2654435761U % 65536) / 65535.0F;
    }
    const auto from =
        lutlib::interleaved(std::as_const(in).data(), lutlib::Element::float32, 3, width, height);
    const auto to = lutlib::interleaved(out.data(), lutlib::Element::float32, 3, width, height);
    double least = std::numeric_limits<double>::infinity();
    for (int round = std::atoi(argv[4]); round > 0; --round) {
        using Clock = std::chrono::steady_clock;
        const Clock::time_point start = Clock::now();
        grade(look, from, to, std::atoi(argv[5]));
        least = std::min(least,
                         std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    std::printf("%.3f\n", least);
}
