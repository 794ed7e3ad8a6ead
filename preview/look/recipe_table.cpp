#include "preview/look/recipe_table.h"

#include "lutlib/metrics/compare.h"
#include "lutlib/recipe/bake_recipe.h"
#include "lutlib/resample/sample_lut.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <numeric>
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

/// Measures the table as measure() does (lutlib/metrics/compare.h), in pieces; false when it was
/// stopped.
bool measure(RecipeTable& table, const lutlib::Viewing& viewing, const lutlib::Transform& exact,
             Stop& stop) {
    constexpr std::size_t at_once = 8192;
    constexpr lutlib::SampleLimits limits{.even = 20'000, .grid = 1 << 17, .between = 1 << 15};
    const lutlib::ErrorSamples samples = error_samples(
        table.lut.domain(), united(lutlib::no_breaks(), breaks_of(table.lut)), limits);
    std::vector<lutlib::Rgb> colours = samples.even;
    colours.insert(colours.end(), samples.hiding.begin(), samples.hiding.end());
    const lutlib::Transform read = lutlib::Transform::of(table.lut);
    const lutlib::Eye eye(viewing);
    const auto errors_of = [&](std::span<const lutlib::Rgb> in, std::span<double> errors) {
        if (stop.asked()) {
            std::fill(errors.begin(), errors.end(), 0);
            return;
        }
        eye(lutlib::Metric::delta_e_2000, images_of(exact, in), images_of(read, in), errors);
    };
    std::vector<double> errors(colours.size());
    for (std::size_t at = 0; at < colours.size(); at += at_once) {
        const std::size_t count = std::min(at_once, colours.size() - at);
        errors_of(std::span(colours).subspan(at, count), std::span(errors).subspan(at, count));
        if (stop.was_asked()) {
            return false;
        }
    }
    const auto even = errors.begin() + static_cast<std::ptrdiff_t>(samples.even.size());
    table.mean_error =
        std::accumulate(errors.begin(), even, 0.0) / static_cast<double>(samples.even.size());
    table.max_error = climbed(colours, errors, samples.axis, errors_of).error;
    return !stop.was_asked();
}

std::optional<RecipeTable> measured(const std::function<lutlib::Lut(int size)>& made,
                                    const lutlib::Transform& exact, const lutlib::Encoding& results,
                                    const std::function<bool()>& asks) {
    RecipeTable table;
    Stop stop(asks);
    for (const int size : sizes) {
        if (stop.asked()) {
            return std::nullopt;
        }
        table = {made(size), 0, 0, 0};
        table.nodes = table.lut.cube ? table.lut.cube->size : 0;
        if (!measure(table, results, exact, stop)) {
            return std::nullopt;
        }
        if (table.max_error < visible_difference) {
            break;
        }
    }
    return table;
}

} // namespace

lutlib::Lut quick_table(const lutlib::Recipe& recipe) {
    return lutlib::bake_recipe(with_size(recipe, sizes[0]));
}

lutlib::Lut quick_table(const lutlib::Transform& look) {
    return sampled(look, sizes[0]);
}

std::optional<RecipeTable> measured_table(const lutlib::Recipe& recipe,
                                          const std::function<bool()>& stop) {
    return measured([&](int size) { return lutlib::bake_recipe(with_size(recipe, size)); },
                    lutlib::Transform::of(recipe), recipe.output_encoding(), stop);
}

std::optional<RecipeTable> measured_table(const lutlib::Transform& look,
                                          const std::function<bool()>& stop) {
    return measured([&](int size) { return sampled(look, size); }, look, lutlib::srgb(), stop);
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
