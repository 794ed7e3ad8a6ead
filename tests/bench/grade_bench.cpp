// A picture of 3840x2160 RGBA through a look of 33 nodes: every element, one thread and two, beside
// memcpy of the same bytes in the same run and OpenColorIO's CPU processor. Figures are ratios of
// one run; items are pixels. `picture/` is smooth with the noise of a sensor, a fiftieth of white;
// `random/` has no neighbours alike, which no picture is.
//
// The floor. memcpy shows what reading and writing the bytes takes. Of a pixel besides, at least:
//
// - Floats, tetrahedral: 24 operations on 16 pixels at a time for its place (3 x 4 for place and
//   fraction, 3 for the cell), 22 for its order and weights, 7 and 8 to put channels and weights
//   where they are wanted, 6 stores: 67 / 16 = 4.2 instructions. Then 2 loads of offsets, 2 of
//   pairs of nodes (32 bytes), 1 of weights to 4 pixels, 1 shuffle and 1 multiply-add to each half
//   pair, 1.25 to add the halves, 0.75 to store: 8 instructions. 12 in all; the processor takes 4
//   to 8 a cycle, half of that where another program shares the core.
// - Trilinear: 4 pairs instead of 2: 17 instructions.
// - 8 bits, tetrahedral: 54 / 16 for place and weights, then 1 load of an offset, 1 of weights, 1
//   shuffle, 1 multiply-add with the whole cell, 4.3 to add its four pairs, round and pack: 12.
#include "lutlib/interpolation/grade.h"

#include <OpenColorIO/OpenColorIO.h>
#include <benchmark/benchmark.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace lutlib;

constexpr std::size_t width = 3840, height = 2160, pixels = width * height;

Lut look_of_33() {
    Lut lut;
    lut.cube = identity_cube(33);
    for (Rgb& c : lut.cube->nodes) {
        const float y = 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b;
        c = {y + 1.3F * (c.r - y), y + 1.3F * (c.g - y), y + 1.3F * (c.b - y)};
    }
    return lut;
}

std::vector<float> make_picture(bool random_colors) {
    std::mt19937 random(1);
    std::vector<float> out(4 * pixels);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto x = static_cast<float>(i / 4 % width) / width;
        const auto y = static_cast<float>(i / 4 / width) / height;
        const float noise = static_cast<float>(random() >> 8) / (1 << 24);
        const std::size_t c = i % 4;
        const float smooth = c == 0   ? 0.5F + 0.5F * std::sin(9 * x + 3 * y)
                             : c == 1 ? 0.5F + 0.45F * std::sin(5 * y - 4 * x)
                             : c == 2 ? (x + y) / 2
                                      : 1;
        out[i] = random_colors ? noise : std::clamp(smooth + 0.02F * (noise - 0.5F), 0.0F, 1.0F);
    }
    return out;
}

struct Buffers {
    std::vector<std::byte> in, out;
};

// Of the element and kind that was last asked for.
Buffers& buffers(Element element, bool random_colors) {
    static std::map<std::pair<Element, bool>, Buffers> kept;
    const std::pair key{element, random_colors};
    if (!kept.contains(key)) {
        kept.clear();
        const std::vector<float> floats = make_picture(random_colors);
        Buffers& made = kept[key];
        made.in.resize(4 * pixels * info_of(element).bytes);
        made.out.resize(made.in.size());
        grade(Grading(Lut{}), interleaved(floats.data(), Element::float32, 4, width, height),
              interleaved(made.in.data(), element, 4, width, height));
    }
    return kept.at(key);
}

struct Case {
    Element element;
    bool random_colors;
    Interpolation how = Interpolation::tetrahedral;
    int threads = 1;
    std::int64_t instruction_set = 0; ///< 0: the best
    std::size_t channels = 4;
};

void count_pixels(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pixels));
}

void graded(benchmark::State& state, const Lut& lut, const Case& c) {
    Buffers& memory = buffers(c.element, c.random_colors);
    const Grading look(lut, c.how);
    const auto in =
        interleaved(std::as_const(memory.in).data(), c.element, c.channels, width, height);
    const auto out = interleaved(memory.out.data(), c.element, c.channels, width, height);
    hwy::SetSupportedTargetsForTest(c.instruction_set);
    for (auto _ : state) {
        grade(look, in, out, c.threads);
        benchmark::ClobberMemory();
    }
    hwy::SetSupportedTargetsForTest(0);
    count_pixels(state);
}

void copied(benchmark::State& state, const Case& c) {
    Buffers& memory = buffers(c.element, c.random_colors);
    for (auto _ : state) {
        std::memcpy(memory.out.data(), memory.in.data(), memory.in.size());
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

// Its processor for packed RGBA of these bits; one thread, as it has no other.
void opencolorio(benchmark::State& state, const Lut& lut, const Case& c) {
    namespace OCIO = OCIO_NAMESPACE;
    const int n = lut.cube->size;
    const auto cube = OCIO::Lut3DTransform::Create(static_cast<unsigned long>(n));
    for (int r = 0; r < n; ++r) {
        for (int g = 0; g < n; ++g) {
            for (int b = 0; b < n; ++b) {
                const Rgb node = lut.cube->at(r, g, b);
                cube->setValue(static_cast<unsigned long>(r), static_cast<unsigned long>(g),
                               static_cast<unsigned long>(b), node.r, node.g, node.b);
            }
        }
    }
    cube->setInterpolation(c.how == Interpolation::tetrahedral ? OCIO::INTERP_TETRAHEDRAL
                                                               : OCIO::INTERP_LINEAR);
    const std::map<Element, OCIO::BitDepth> depths{{Element::uint8, OCIO::BIT_DEPTH_UINT8},
                                                   {Element::uint16, OCIO::BIT_DEPTH_UINT16},
                                                   {Element::half, OCIO::BIT_DEPTH_F16},
                                                   {Element::float32, OCIO::BIT_DEPTH_F32}};
    const OCIO::BitDepth depth = depths.at(c.element);
    const auto processor = OCIO::Config::CreateRaw()->getProcessor(cube)->getOptimizedCPUProcessor(
        depth, depth, OCIO::OPTIMIZATION_DEFAULT);
    Buffers& memory = buffers(c.element, c.random_colors);
    const auto bytes = static_cast<std::ptrdiff_t>(info_of(c.element).bytes);
    const auto view = [&](std::vector<std::byte>& samples) {
        return OCIO::PackedImageDesc(samples.data(), width, height, 4, depth, bytes, 4 * bytes,
                                     4 * bytes * static_cast<std::ptrdiff_t>(width));
    };
    OCIO::PackedImageDesc from = view(memory.in), to = view(memory.out);
    for (auto _ : state) {
        processor->apply(from, to);
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

} // namespace

int main(int argc, char** argv) {
    static const Lut look = look_of_33();
    const auto add = [](const std::string& name, auto run) {
        benchmark::RegisterBenchmark(name.c_str(), run)
            ->Unit(benchmark::kMillisecond)
            ->MeasureProcessCPUTime()
            ->UseRealTime();
    };
    for (const bool random_colors : {false, true}) {
        for (const Element element :
             {Element::float32, Element::half, Element::uint16, Element::uint8}) {
            const std::string kind = std::string(random_colors ? "random/" : "picture/") +
                                     std::string(info_of(element).name) + "/";
            Case c{element, random_colors};
            add(kind + "memcpy", [=](auto& s) { copied(s, c); });
            for (const Interpolation how : {Interpolation::tetrahedral, Interpolation::trilinear}) {
                const std::string name = kind + std::string(name_of(how)) + "/";
                c = {element, random_colors, how};
                add(name + "one_thread", [=](auto& s) { graded(s, look, c); });
                add(name + "opencolorio", [=](auto& s) { opencolorio(s, look, c); });
                c.threads = 2;
                add(name + "two_threads", [=](auto& s) { graded(s, look, c); });
                c.threads = 1;
                c.instruction_set = HWY_AVX2;
                add(name + "one_thread_avx2", [=](auto& s) { graded(s, look, c); });
                c.instruction_set = 0;
                c.channels = 3;
                add(name + "one_thread_rgb", [=](auto& s) { graded(s, look, c); });
            }
        }
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
