#include "preview/look/recipe_table.h"

#include "lutlib/metrics/compare.h"
#include "lutlib/recipe/bake_recipe.h"
#include "lutlib/resample/sample_lut.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <span>

namespace preview {

namespace {

constexpr int sizes[] = {33, 65, 97}; // the first is the quick one

lutlib::Recipe with_size(const lutlib::Recipe& recipe, int size) {
    lutlib::Recipe out = recipe;
    out.bake.size = std::max(size, recipe.bake.size.value_or(0));
    return out;
}

lutlib::Lut sampled(const lutlib::Transform& look, int size) {
    lutlib::Lut out;
    out.cube = lutlib::sample_cube(look, {}, size);
    return out;
}

/// What a table stands for.
struct Look {
    lutlib::Transform exact;
    lutlib::Breaks breaks;
    lutlib::Encoding results;
};

/// Asks whether to stop, from any thread, and never again after that said so.
class Stop {
  public:
    explicit Stop(const std::function<bool()>& stop) : stop_(stop) {}

    bool asked() {
        const std::lock_guard lock(mutex_);
        stopped_ = stopped_ || stop_();
        return stopped_;
    }
    bool was_asked() {
        const std::lock_guard lock(mutex_);
        return stopped_;
    }

  private:
    const std::function<bool()>& stop_;
    std::mutex mutex_;
    bool stopped_ = false;
};

/// The same colours as every verb of lutconv measures a table by, fewer of each kind; false when it
/// was stopped.
bool measure(RecipeTable& table, const Look& look, Stop& stop) {
    constexpr lutlib::SampleLimits limits{.even = 20'000, .grid = 1 << 17, .between = 1 << 15};
    const lutlib::ErrorSamples samples =
        error_samples(table.lut.domain(), united(look.breaks, breaks_of(table.lut)), limits);
    // Once it shall stop nothing is worked out any more, so that it soon does.
    const auto exact = lutlib::Transform::batch([&](std::span<lutlib::RgbD> colors) {
        if (!stop.asked()) {
            look.exact(colors);
        }
    });
    const auto read = lutlib::Transform::of(table.lut);
    table.mean_error = compare(exact, read, samples.even, look.results).delta_e_2000.mean;
    if (!stop.was_asked()) {
        table.max_error =
            largest_difference(exact, read, samples, look.results, lutlib::Metric::delta_e_2000)
                .error;
    }
    return !stop.was_asked();
}

} // namespace

lutlib::Lut quick_table(const lutlib::Recipe& recipe) {
    return lutlib::bake_recipe(with_size(recipe, sizes[0]));
}

lutlib::Lut quick_table(const lutlib::Transform& look) {
    return sampled(look, sizes[0]);
}

std::optional<RecipeTable> measured_table(const lutlib::Recipe& recipe,
                                          const std::function<bool()>& asks) {
    const Look look{lutlib::Transform::of(recipe),
                    recipe.base_lut ? united(lutlib::no_breaks(), breaks_of(*recipe.base_lut))
                                    : lutlib::no_breaks(),
                    recipe.output_encoding()};
    RecipeTable table;
    Stop stop(asks);
    for (const int size : sizes) {
        if (stop.asked()) {
            return std::nullopt;
        }
        table = {lutlib::bake_recipe(with_size(recipe, size)), 0, 0, 0};
        table.nodes = table.lut.cube ? table.lut.cube->size : 0;
        if (!measure(table, look, stop)) {
            return std::nullopt;
        }
        if (table.max_error < visible_difference) {
            break;
        }
    }
    return table;
}

LoadedLook measured_look(const RecipeTable& table, const GpuLookup& lookup) {
    LoadedLook look = look_for(std::make_shared<const lutlib::Lut>(table.lut), lookup);
    look.note = fmt::format(
        "{} nodes per axis, dE2000 {:.3f} on average and {:.2f} at most, as far as seen, "
        "of the look itself",
        table.nodes, table.mean_error, table.max_error);
    return look;
}

} // namespace preview
