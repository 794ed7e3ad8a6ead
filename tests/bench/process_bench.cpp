// Whole processes, as a user pays for them: lutconv bake, without and with measuring what it made,
// against ociolutimage + ocioconvert (a lattice picture, then the look through it), which measure
// nothing. Prints wall time and peak memory, median of alternating runs, and their ratios.
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

extern char** environ;

namespace {

struct Cost {
    double milliseconds = 0;
    double megabytes = 0;
};

Cost run(std::vector<std::string> words) {
    std::vector<char*> argv;
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, 2, "/dev/null", O_WRONLY, 0);
    const auto start = std::chrono::steady_clock::now();
    pid_t child = 0;
    int status = 1;
    rusage used{};
    if (posix_spawnp(&child, argv[0], &files, nullptr, argv.data(), environ) != 0 ||
        wait4(child, &status, 0, &used) != child || status != 0) {
        std::fprintf(stderr, "process_bench: %s failed\n", argv[0]);
        std::exit(1);
    }
    posix_spawn_file_actions_destroy(&files);
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    return {wall.count(), static_cast<double>(used.ru_maxrss) / 1024};
}

Cost median(std::vector<Cost> costs) {
    const auto middle = [&](double Cost::*figure) {
        std::sort(costs.begin(), costs.end(),
                  [&](const Cost& a, const Cost& b) { return a.*figure < b.*figure; });
        return costs[costs.size() / 2].*figure;
    };
    return {middle(&Cost::milliseconds), middle(&Cost::megabytes)};
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: process_bench LOOK.cube [RUNS]\n");
        return 3;
    }
    const std::string look = argv[1];
    const int runs = argc > 2 ? std::atoi(argv[2]) : 15;
    std::string folder = "/tmp/process_bench-XXXXXX";
    if (!mkdtemp(folder.data())) {
        return 2;
    }
    std::vector<Cost> ours, measured, theirs;
    for (int i = -1; i < runs; ++i) {
        const Cost bake = run({LUTCONV, "bake", look, "-o", folder + "/ours.png"});
        const Cost with_figures =
            run({LUTCONV, "bake", look, "-o", folder + "/ours.png", "--measure"});
        const Cost lattice = run({"ociolutimage", "--generate", "--cubesize", "16", "--output",
                                  folder + "/lattice.exr"});
        const Cost convert =
            run({"ocioconvert", "--lut", look, folder + "/lattice.exr", folder + "/theirs.png"});
        if (i >= 0) { // The first round only warms the caches.
            ours.push_back(bake);
            measured.push_back(with_figures);
            theirs.push_back({lattice.milliseconds + convert.milliseconds,
                              std::max(lattice.megabytes, convert.megabytes)});
        }
    }
    const Cost peer = median(theirs);
    std::printf("%-28s %10s %10s %8s %8s\n", "whole process, median", "wall ms", "peak MB",
                "faster", "smaller");
    const auto row = [&](const char* name, const Cost& cost) {
        std::printf("%-28s %10.1f %10.1f %7.1fx %7.1fx\n", name, cost.milliseconds, cost.megabytes,
                    peer.milliseconds / cost.milliseconds, peer.megabytes / cost.megabytes);
    };
    row("lutconv bake", median(ours));
    row("lutconv bake --measure", median(measured));
    row("ociolutimage + ocioconvert", peer);
    for (const char* name : {"/ours.png", "/lattice.exr", "/theirs.png"}) {
        unlink((folder + name).c_str());
    }
    rmdir(folder.c_str());
}
