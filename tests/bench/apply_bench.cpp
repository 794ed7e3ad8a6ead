// A picture of 1920x1080 RGBA floats through a look of 33 nodes: the fast path on one core and on
// all, the plain loop over evaluate(), memcpy of the same bytes, and OpenColorIO's CPU processor.
// Figures are ratios of one run; items are pixels. The pixels are random, which is harder on the
// caches than any picture, or smooth as a picture is.
//
// The floor. Each pixel is 16 bytes read and 16 written: 66 MB a picture, and 33 MB more where the
// write first fetches its line; at 20 GB/s of one core that is 3 to 5 ms, which memcpy shows. The
// lattice, 431 kB, stays in the second-level cache. Arithmetic of tetrahedral interpolation, a
// pixel: 3 x (1 subtraction, 1 division, 2 comparisons, 1 multiplication, 2 conversions, 1
// subtraction) for its place, 3 exchanges of 5 instructions for its order, 4 subtractions for the
// weights, all of them 8 or 16 pixels at a time; then 4 loads and 4 x 4 multiplications and 3 x 4
// additions, four to an instruction. Some 60 / 8 + 20 instructions: at 4 a cycle and 3 GHz 2.3 ns a
// pixel, 5 ms a picture, about what the memory takes. Trilinear does 8 loads and 7 mixtures of 3
// operations: 5 ns.
#include "lutlib/interpolation/apply.h"

#include <OpenColorIO/OpenColorIO.h>
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

namespace {

using namespace lutlib;

constexpr std::size_t width = 1920, height = 1080, pixels = width * height;

Lut look_of_33() {
    Lut lut;
    lut.cube = identity_cube(33);
    for (Rgb& c : lut.cube->nodes) {
        const float y = 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b;
        c = {y + 1.3F * (c.r - y), y + 1.3F * (c.g - y), y + 1.3F * (c.b - y)};
    }
    return lut;
}

Lut shaped_look() {
    Lut lut = look_of_33();
    lut.shaper.emplace();
    for (int i = 0; i < 1024; ++i) {
        const float v = std::sqrt(static_cast<float>(i) / 1023);
        lut.shaper->entries.push_back({v, v, v});
    }
    return lut;
}

const std::vector<float>& picture(bool smooth) {
    static const auto make = [](bool even) {
        std::mt19937 random(1);
        std::uniform_real_distribution<float> value(0, 1);
        std::vector<float> out(4 * pixels);
        for (std::size_t i = 0; i < out.size(); ++i) {
            const auto x = static_cast<float>(i / 4 % width) / width;
            const auto y = static_cast<float>(i / 4 / width) / height;
            const std::size_t c = i % 4;
            out[i] = !even ? value(random) : c == 0 ? x : c == 1 ? y : c == 2 ? (x + y) / 2 : 1;
        }
        return out;
    };
    static const std::vector<float> pictures[] = {make(false), make(true)};
    return pictures[smooth];
}

void count_pixels(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pixels));
}

void fast(benchmark::State& state, const Lut& lut, Interpolation how, bool smooth, bool all) {
    const StoredLut stored(lut);
    const std::vector<float>& in = picture(smooth);
    std::vector<float> out(in.size());
    for (auto _ : state) {
        (all ? apply : apply_on_this_thread)(stored, lookup_of(how), in.data(), out.data(), pixels,
                                             4);
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

void plain_loop(benchmark::State& state, const Lut& lut, Interpolation how, bool smooth) {
    const std::vector<float>& in = picture(smooth);
    std::vector<float> out(in.size());
    for (auto _ : state) {
        for (std::size_t i = 0; i < in.size(); i += 4) {
            const Rgb c = evaluate(lut, {in[i], in[i + 1], in[i + 2]}, how);
            out[i] = c.r;
            out[i + 1] = c.g;
            out[i + 2] = c.b;
            out[i + 3] = in[i + 3];
        }
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

// Its processor of packed float RGBA as it is by default; one thread, as it has no other.
void opencolorio(benchmark::State& state, const Lut& lut, Interpolation how, bool smooth) {
    namespace OCIO = OCIO_NAMESPACE;
    const int n = lut.cube->size;
    const auto cube = OCIO::Lut3DTransform::Create(static_cast<unsigned long>(n));
    for (int r = 0; r < n; ++r) {
        for (int g = 0; g < n; ++g) {
            for (int b = 0; b < n; ++b) {
                const Rgb c = lut.cube->at(r, g, b);
                cube->setValue(static_cast<unsigned long>(r), static_cast<unsigned long>(g),
                               static_cast<unsigned long>(b), c.r, c.g, c.b);
            }
        }
    }
    cube->setInterpolation(how == Interpolation::tetrahedral ? OCIO::INTERP_TETRAHEDRAL
                                                             : OCIO::INTERP_LINEAR);
    const auto processor = OCIO::Config::CreateRaw()->getProcessor(cube)->getDefaultCPUProcessor();
    std::vector<float> in = picture(smooth);
    std::vector<float> out(in.size());
    OCIO::PackedImageDesc from(in.data(), width, height, 4), to(out.data(), width, height, 4);
    for (auto _ : state) {
        processor->apply(from, to);
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

void copy_bytes(benchmark::State& state, bool smooth) {
    const std::vector<float>& in = picture(smooth);
    std::vector<float> out(in.size());
    for (auto _ : state) {
        std::memcpy(out.data(), in.data(), in.size() * sizeof(float));
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

} // namespace

int main(int argc, char** argv) {
    static const Lut cube = look_of_33(), shaped = shaped_look();
    const auto add = [](const std::string& name, auto run) {
        benchmark::RegisterBenchmark(name.c_str(), run)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    };
    for (const bool smooth : {false, true}) {
        const std::string kind = smooth ? "smooth/" : "random/";
        for (const InterpolationInfo& row : interpolations()) {
            const std::string name = kind + std::string(row.name) + "/";
            const Interpolation how = row.kind;
            add(name + "one_core", [=](auto& s) { fast(s, cube, how, smooth, false); });
            add(name + "all_cores", [=](auto& s) { fast(s, cube, how, smooth, true); });
            add(name + "plain_loop", [=](auto& s) { plain_loop(s, cube, how, smooth); });
            if (how != Interpolation::nearest) {
                add(name + "opencolorio", [=](auto& s) { opencolorio(s, cube, how, smooth); });
            }
        }
        const Interpolation best = Interpolation::tetrahedral;
        add(kind + "shaper_tetrahedral/one_core",
            [=](auto& s) { fast(s, shaped, best, smooth, false); });
        add(kind + "shaper_tetrahedral/plain_loop",
            [=](auto& s) { plain_loop(s, shaped, best, smooth); });
        add(kind + "memcpy", [=](auto& s) { copy_bytes(s, smooth); });
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
