#include "lutlib/recipe/bake_recipe.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/recipe/edit.h"
#include "lutlib/resample/resample.h"
#include "lutlib/resample/sample_lut.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

Lut1D tone_shaper(const Edit& edit, const Domain& domain, int size) {
    const auto n = static_cast<std::size_t>(size);
    std::vector<RgbD> neutrals(n);
    Lut1D table{domain, std::vector<Rgb>(n)};
    for (int i = 0; i < size; ++i) {
        neutrals[static_cast<std::size_t>(i)] = entry_position(table, i);
    }
    edit(neutrals);
    // The mean of the channels, which must not fall.
    std::vector<double> rise(n);
    double highest = -INFINITY;
    for (std::size_t i = 0; i < n; ++i) {
        highest = std::max(highest, (neutrals[i].r + neutrals[i].g + neutrals[i].b) / 3);
        rise[i] = highest;
    }
    const double span = rise.back() - rise.front();
    for (std::size_t i = 0; i < n; ++i) {
        const double line = static_cast<double>(i) / static_cast<double>(n - 1);
        const double tone = span > 0 ? (rise[i] - rise.front()) / span : line;
        const auto y = static_cast<float>((tone + line) / 2);
        table.entries[i] = {y, y, y};
    }
    return table;
}

} // namespace

Lut bake_recipe(const Recipe& recipe) {
    const Edit edit(recipe);
    const BakeSettings& settings = recipe.bake;
    const Lut none;
    const Lut& base = recipe.base_lut ? *recipe.base_lut : none;
    const Transform whole = [&edit](std::span<RgbD> colours) { edit(colours); };
    Lut out;
    if (settings.shaper == "tone") {
        const Domain domain = settings.domain.value_or(base.domain());
        check_domain(domain);
        check_shaper_size(settings.shaper_size);
        out.shaper = tone_shaper(edit, domain, settings.shaper_size);
        out.cube = sample_cube_behind(
            whole, *out.shaper,
            settings.size.value_or(base.cube ? base.cube->size : usual_cube_size));
    } else {
        const Transform after_table = [&](std::span<RgbD> colours) {
            if (base.cube) {
                for (RgbD& c : colours) {
                    c = evaluate_exact(*base.cube, c, Interpolation::tetrahedral);
                }
            }
            edit.after_base(colours);
        };
        out = sample_like(
            base,
            {settings.size, settings.domain, settings.shaper, settings.shaper_size, recipe.input},
            whole, after_table);
    }
    out.title = recipe.title;
    return out;
}

} // namespace lutlib
