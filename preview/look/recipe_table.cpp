#include "preview/look/recipe_table.h"

#include "lutlib/metrics/compare.h"
#include "lutlib/recipe/bake_recipe.h"
#include "lutlib/resample/sample_lut.h"

#include <fmt/format.h>

#include <algorithm>

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

/// Measures the table; false when it was stopped.
bool measure(RecipeTable& table, const lutlib::Encoding& results, const lutlib::Transform& exact,
             const std::function<bool()>& stop) {
    constexpr std::size_t at_once = 8192;
    // The nodes and cell centres of the quick table, and as many places anywhere.
    static const std::vector<lutlib::Rgb> colours =
        lutlib::samples_over(lutlib::Domain{}, sizes[0], 70'000);
    const lutlib::Transform read = lutlib::Transform::of(table.lut);
    double sum = 0;
    for (std::size_t at = 0; at < colours.size(); at += at_once) {
        if (stop()) {
            return false;
        }
        const std::vector<lutlib::Rgb> inputs(
            colours.begin() + static_cast<std::ptrdiff_t>(at),
            colours.begin() + static_cast<std::ptrdiff_t>(std::min(at + at_once, colours.size())));
        std::vector<lutlib::RgbD> wanted;
        for (const lutlib::Rgb& in : inputs) {
            wanted.push_back(lutlib::to_double(in));
        }
        std::vector<lutlib::RgbD> got = wanted;
        exact(wanted);
        read(got);
        const lutlib::ErrorStats errors =
            lutlib::difference_of(inputs, wanted, got, results).delta_e_2000;
        table.max_error = std::max(table.max_error, errors.max);
        sum += errors.mean * static_cast<double>(errors.count);
    }
    table.mean_error = sum / static_cast<double>(colours.size());
    return true;
}

std::optional<RecipeTable> measured(const std::function<lutlib::Lut(int size)>& made,
                                    const lutlib::Transform& exact, const lutlib::Encoding& results,
                                    const std::function<bool()>& stop) {
    RecipeTable table;
    for (const int size : sizes) {
        if (stop()) {
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
    look.note =
        fmt::format("{} nodes per axis, within dE2000 {:.2f} of the look itself, {:.3f} on average",
                    table.nodes, table.max_error, table.mean_error);
    return look;
}

} // namespace preview
