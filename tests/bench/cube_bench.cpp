// Parsing a .cube from memory: ours, a plain std::from_chars loop over the same bytes (which a test
// holds to be bit-identical), OpenColorIO's loader, and memcpy of the bytes as the floor. Figures
// are ratios of one run.
#include "lutlib/formats/cube.h"
#include "lutlib/io/ocio.h"
#include "tests/lutlib/formats/plain_cube_reader.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace {

// Six decimals a value, as most exporters write.
std::string six_decimals(int size) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(0, 1);
    std::string out = "TITLE \"bench\"\nLUT_3D_SIZE " + std::to_string(size) + "\n";
    char row[64];
    for (int i = 0; i < size * size * size; ++i) {
        const int n = std::snprintf(row, sizeof row, "%.6f %.6f %.6f\n", value(random),
                                    value(random), value(random));
        out.append(row, static_cast<std::size_t>(n));
    }
    return out;
}

std::string shortest_decimals(int size) {
    lutlib::Lut lut;
    lut.cube = lutlib::identity_cube(size);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(0, 1);
    for (lutlib::Rgb& node : lut.cube->nodes) {
        node = {value(random), value(random), value(random)};
    }
    return write_cube(lut, lutlib::CubeDialect::adobe);
}

void count_bytes(benchmark::State& state, const std::string& text) {
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(text.size()));
}

void parse_ours(benchmark::State& state, const std::string& text) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(lutlib::read_cube(text, "bench.cube"));
    }
    count_bytes(state, text);
}

void parse_from_chars(benchmark::State& state, const std::string& text) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(lutlib::plain_read_rows(text));
    }
    count_bytes(state, text);
}

// What Debian's OpenColorIO needs to load the same bytes: its parse and its validation.
void parse_opencolorio(benchmark::State& state, const std::string& text) {
    std::size_t run = 0;
    for (auto _ : state) {
        // OpenColorIO caches files by name; a name of its own makes each run read again.
        const std::string name = "bench" + std::to_string(run++) + ".cube";
        benchmark::DoNotOptimize(lutlib::io::ocio().parse(text, "cube", name, {}));
    }
    count_bytes(state, text);
}

void copy_bytes(benchmark::State& state, const std::string& text) {
    std::vector<char> target(text.size());
    for (auto _ : state) {
        std::memcpy(target.data(), text.data(), text.size());
        benchmark::ClobberMemory();
    }
    count_bytes(state, text);
}

} // namespace

int main(int argc, char** argv) {
    static const std::string six_33 = six_decimals(33), six_65 = six_decimals(65),
                             short_33 = shortest_decimals(33);
    const auto add = [](const char* name, void (*f)(benchmark::State&, const std::string&),
                        const std::string& text) {
        benchmark::RegisterBenchmark(name, [f, &text](benchmark::State& s) {
            f(s, text);
        })->Unit(benchmark::kMicrosecond);
    };
    add("33/six_decimals/ours", parse_ours, six_33);
    add("33/six_decimals/from_chars", parse_from_chars, six_33);
    add("33/six_decimals/opencolorio", parse_opencolorio, six_33);
    add("33/six_decimals/memcpy", copy_bytes, six_33);
    add("65/six_decimals/ours", parse_ours, six_65);
    add("65/six_decimals/from_chars", parse_from_chars, six_65);
    add("33/shortest/ours", parse_ours, short_33);
    add("33/shortest/from_chars", parse_from_chars, short_33);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
