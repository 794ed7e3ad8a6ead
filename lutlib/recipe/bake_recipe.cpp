#include "lutlib/recipe/bake_recipe.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/resample/curves.h"
#include "lutlib/resample/resample.h"
#include "lutlib/resample/sample_lut.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace lutlib {
namespace {

Lut1D tone_shaper(const Transform& look, const Domain& domain, int size) {
    const auto n = static_cast<std::size_t>(size);
    std::vector<RgbD> neutrals(n);
    Lut1D table{domain, std::vector<Rgb>(n)};
    for (int i = 0; i < size; ++i) {
        neutrals[static_cast<std::size_t>(i)] = entry_position(table, i);
    }
    look(neutrals);
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

bool is_active(const Operation& operation) {
    return operation.enabled && !is_identity(operation);
}

// A recipe that does nothing is a lattice, as its size says; a curve must come from somewhere.
bool is_curve(const Recipe& recipe) {
    const bool bends = (recipe.base_lut && recipe.base_lut->shaper) ||
                       recipe.output_encoding() != recipe.input ||
                       std::any_of(recipe.operations.begin(), recipe.operations.end(), is_active);
    return bends && recipe.bake.shaper.empty() && !recipe.bake.size && !mixes_channels(recipe);
}

} // namespace

bool mixes_channels(const Recipe& recipe) {
    const bool one_gamut =
        recipe.output_encoding().gamut == recipe.input.gamut &&
        (recipe.opacity == 1 || without_look(recipe).input.gamut == recipe.input.gamut);
    const auto mixes = [](const Operation& operation) {
        const auto per_channel = operation.op->per_channel;
        return is_active(operation) && !(per_channel && per_channel(operation.values));
    };
    return !one_gamut || (recipe.base_lut && !is_curves(*recipe.base_lut)) ||
           std::any_of(recipe.operations.begin(), recipe.operations.end(), mixes);
}

Lut bake_recipe(const Recipe& recipe) {
    const Transform whole = Transform::of(recipe);
    const BakeSettings& settings = recipe.bake;
    const Lut none;
    const Lut& base = recipe.base_lut ? *recipe.base_lut : none;
    Lut out;
    if (is_curve(recipe)) {
        constexpr int least_entries = 4096;
        out.shaper = sample_curve_closely(whole, settings.domain.value_or(base.domain()),
                                          base.shaper ? base.shaper->size() : least_entries,
                                          curve_tolerance);
    } else if (settings.shaper == "tone") {
        const Domain domain = settings.domain.value_or(base.domain());
        check_domain(domain);
        check_shaper_size(settings.shaper_size);
        out.shaper = tone_shaper(whole, domain, settings.shaper_size);
        out.cube = sample_cube_behind(
            whole, *out.shaper,
            settings.size.value_or(base.cube ? base.cube->size : usual_cube_size));
    } else {
        // A base's 1D table stands before the new cube as it is.
        Recipe behind_table = recipe;
        if (base.shaper) {
            Lut cube_only;
            cube_only.cube = base.cube;
            cube_only.interpolation = base.interpolation;
            behind_table.base_lut = std::make_shared<const Lut>(std::move(cube_only));
        }
        out = sample_like(
            base,
            {settings.size, settings.domain, settings.shaper, settings.shaper_size, recipe.input},
            whole, Transform::of(behind_table));
    }
    out.title = recipe.title;
    out.encodings = names_of(encodings_of(recipe));
    return out;
}

} // namespace lutlib
