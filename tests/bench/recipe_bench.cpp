// Baking a recipe of eight operators: what a slider in a window, and a final export, wait for.
// Reports wall time and the CPU time of all threads.
#include "lutlib/recipe/bake_recipe.h"

#include <benchmark/benchmark.h>

#include <array>

namespace {

using namespace lutlib;

Recipe eight_operators(const Encoding& encoding) {
    const auto with = [](const char* name, const Values& values) {
        return Operation{op_named(name), values, true};
    };
    Recipe recipe;
    recipe.input = encoding;
    recipe.operations = {
        with("exposure", {0.3}),
        with("white-balance", {5200.0, 4.0}),
        with("lift-gamma-gain", {RgbD{.01, 0, .02}, RgbD{1.1, 1, .95}, RgbD{1, 1.02, .98}}),
        with("contrast", {1.15, .435}),
        with("curves", {Knots{{0, 0}, {.25, .2}, {.75, .82}, {1, 1}}, Knots{}, Knots{},
                        Knots{{0, .03}, {1, .97}}}),
        with("saturation", {1.2}),
        with("hue-vs-sat", {Knots{{0, 1.1}, {60, 1}, {120, .7}, {200, 1.3}, {300, 1}}}),
        with("split-toning", {210.0, .3, 35.0, .3, .5}),
    };
    return recipe;
}

void bake_eight_operators(benchmark::State& state) {
    constexpr std::array inputs{"srgb", "logc3", "pq"};
    Recipe recipe =
        eight_operators(require_encoding(inputs[static_cast<std::size_t>(state.range(1))]));
    recipe.bake.size = static_cast<int>(state.range(0));
    double stops = 0;
    for (auto _ : state) {
        // A slider moves: nothing of the last bake can be used again.
        recipe.operations[0].values[0] = stops += 0.001;
        benchmark::DoNotOptimize(bake_recipe(recipe));
    }
    state.SetLabel(recipe.input.name());
}
BENCHMARK(bake_eight_operators)
    ->ArgsProduct({{33, 65}, {0, 1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

} // namespace

BENCHMARK_MAIN();
