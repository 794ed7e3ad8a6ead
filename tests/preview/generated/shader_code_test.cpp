// The code that `lutconv shader` writes, on a device, against the CPU's lookup of the same codes.
#include "lutlib/engine/shader_code.h"

#include "lutlib/interpolation/interpolation.h"
#include "preview/gpu/shaders.h"
#include "tests/preview/graph/gpu_test.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace preview {
namespace {

constexpr std::size_t count = 100'000;

// Noise, so that every node differs from the next by half the range.
lutlib::Picture noise(lutlib::PictureSize size) {
    std::mt19937 random(7);
    lutlib::Picture out{size.width, size.height, {}};
    for (int i = 0; i < size.width * size.height; ++i) {
        const auto code = [&] { return static_cast<float>(random() % 256) / 255; };
        out.pixels.push_back({code(), code(), code()});
    }
    return out;
}

// Colours of 0..1 and a little beyond, ends, and what is no number.
std::vector<std::array<float, 4>> colors() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    infinite = std::numeric_limits<float>::infinity();
    std::vector<std::array<float, 4>> out{{0, 0, 0, 1},
                                          {1, 1, 1, 1},
                                          {0, 1, .5F, 1},
                                          {nan, .5F, .25F, 1},
                                          {infinite, .5F, .1F, 1},
                                          {.2F, -infinite, .9F, 1}};
    std::mt19937 random(11);
    std::uniform_real_distribution<float> value(-0.05F, 1.05F);
    while (out.size() < count) {
        out.push_back({value(random), value(random), value(random), 1});
    }
    return out;
}

// In double: where the engine's row puts a colour, its nodes by layout.pixel(), weighed.
lutlib::RgbD expected(const lutlib::Engine& engine, const lutlib::Picture& picture, int n,
                      lutlib::Interpolation how, const std::array<float, 4>& color) {
    lutlib::RgbD place;
    for (std::size_t c = 0; c < 3; ++c) {
        const double in = color[c] > 0 ? std::min<double>(color[c], 1) : 0;
        place[c] = engine.place(in, n);
    }
    const lutlib::NodeWeights weights = lutlib::node_weights(how, n, place);
    const bool light = engine.filtering == lutlib::Filtering::light;
    lutlib::RgbD sum;
    for (std::size_t k = 0; k < weights.count; ++k) {
        const auto index = static_cast<int>(weights.node[k]);
        const lutlib::Pixel at =
            lutlib::layout_named(engine.layout)
                ->pixel(n, picture.width, index % n, index / n % n, index / n / n);
        const lutlib::Rgb& code = picture.at(at.x, at.y);
        for (std::size_t c = 0; c < 3; ++c) {
            const double v = code[c];
            const double decoded = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
            sum[c] += weights.weight[k] * (light ? decoded : v);
        }
    }
    for (std::size_t c = 0; light && c < 3; ++c) {
        sum[c] = sum[c] <= 0.0031308 ? sum[c] * 12.92 : 1.055 * std::pow(sum[c], 1 / 2.4) - 0.055;
    }
    return sum;
}

// Nodes at half a place between them are either's.
bool is_tie(const lutlib::Engine& engine, int n, const std::array<float, 4>& color) {
    return std::any_of(color.begin(), color.begin() + 3, [&](float in) {
        const double place = engine.place(in > 0 ? std::min<double>(in, 1) : 0, n);
        return std::abs(place - std::floor(place) - 0.5) < 1e-4;
    });
}

class ShaderCode : public GpuTest {
  protected:
    static std::vector<float> run(const std::string& shader, const lutlib::Picture& picture,
                                  const std::vector<std::array<float, 4>>& in) {
        const ImageDesc desc{Format::rgba32f, static_cast<std::uint32_t>(picture.width),
                             static_cast<std::uint32_t>(picture.height)};
        std::vector<float> texels;
        for (const lutlib::Rgb& pixel : picture.pixels) {
            texels.insert(texels.end(), {pixel.r, pixel.g, pixel.b, 1});
        }
        const gpu::Image strip = upload(desc, texels);
        const std::uint64_t bytes = in.size() * sizeof(in.front());
        const gpu::Buffer given = gpu::make_buffer(device(), std::as_bytes(std::span(in)));
        Graph graph;
        Pass pass = graph.compute("lookup", shader);
        pass.read(graph.import("strip", strip, desc));
        pass.storage(graph.import("colours", given, bytes));
        const BufferHandle results = pass.write(graph.buffer("results", bytes));
        pass.dispatch(static_cast<std::uint32_t>((in.size() + 63) / 64));
        graph.present(results);
        Executor executor(device());
        executor.render(graph);
        return as<float>(executor.read_buffer(results));
    }
};

TEST_F(ShaderCode, of_every_engine_and_interpolation_gives_what_the_cpu_does) {
    const std::vector<std::array<float, 4>> in = colors();
    for (const lutlib::Engine& engine : lutlib::engines()) {
        const int n = engine.default_size;
        lutlib::Picture picture = noise(*lutlib::layout_named(engine.layout)->picture(n));
        lutlib::Picture loaded = picture;
        if (engine.name == "unity") { // its textures begin with the bottom row
            for (int y = 0; y < picture.height; ++y) {
                for (int x = 0; x < picture.width; ++x) {
                    loaded.at(x, y) = picture.at(x, picture.height - 1 - y);
                }
            }
        }
        for (const lutlib::InterpolationInfo& row : lutlib::interpolations()) {
            std::vector<lutlib::RgbD> right;
            for (const auto& color : in) {
                right.push_back(expected(engine, picture, n, row.kind, color));
            }
            for (const char* const suffix : {".comp", ".comp.hlsl"}) {
                const std::string shader =
                    std::string(engine.name) + "_" + std::string(row.name) + suffix;
                const std::vector<float> out = run(shader, loaded, in);
                double worst = 0, engines_own = 0;
                for (std::size_t i = 0; i < in.size(); ++i) {
                    const lutlib::RgbD got{out[4 * i], out[4 * i + 1], out[4 * i + 2]};
                    if (row.kind != lutlib::Interpolation::nearest || !is_tie(engine, n, in[i])) {
                        worst = std::max(worst, largest_magnitude(got - right[i]));
                    }
                    if (row.kind == engine.interpolation && i % 16 == 0) {
                        const lutlib::Rgb own =
                            engine.lookup(picture, n, {in[i][0], in[i][1], in[i][2]});
                        engines_own =
                            std::max(engines_own, largest_magnitude(got - lutlib::to_double(own)));
                    }
                }
                // Places among 64 nodes are good to 4e-6 in floats, times a step of up to 1.
                EXPECT_LT(worst, engine.filtering == lutlib::Filtering::light ? 1e-4 : 2e-5)
                    << shader;
                EXPECT_LT(engines_own, 2e-4) << shader;
            }
        }
    }
}

} // namespace
} // namespace preview
