#include "lutlib/survey/survey.h"

#include "lutlib/bake/budget.h"
#include "lutlib/metrics/samples.h"
#include "tests/lutlib/looks.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

Recipe recipe_of(RgbD (*f)(RgbD)) {
    Lut lut;
    lut.cube = sampled(f, 17);
    Recipe recipe;
    recipe.base = "look";
    recipe.base_lut = std::make_shared<const Lut>(std::move(lut));
    return recipe;
}

SurveySettings small() {
    SurveySettings out;
    out.sizes = {8, 9};
    out.samples = {.even = 1500, .grid = 1000, .between = 300};
    out.pixels = 256;
    out.rounds = 3;
    out.own_size = false;
    return out;
}

TEST(Survey, measures_every_combination_of_storage_and_lookup_for_each_size) {
    const Survey result =
        survey(recipe_of(test_looks()[1].f), small(), [](double, const std::string&) {});
    for (const int size : small().sizes) {
        for (const Storage& storage : storages()) {
            for (const Lookup& lookup : lookups()) {
                const auto row =
                    std::find_if(result.rows.begin(), result.rows.end(), [&](const SurveyRow& r) {
                        return r.what.size == size && r.what.storage == &storage &&
                               r.what.lookup == &lookup && !r.what.fitted &&
                               r.what.shaper->name == "none";
                    });
                ASSERT_NE(row, result.rows.end());
                EXPECT_GT(row->pixel.median, 0);
                EXPECT_LE(row->pixel.low, row->pixel.median);
                EXPECT_GE(row->pixel.high, row->pixel.median);
                EXPECT_EQ(row->bytes, static_cast<std::size_t>(size * size * size) * storage.bytes);
                EXPECT_GT(row->error.delta_e_2000.max, 0);
            }
        }
    }
    // The input is sRGB, so encoding it as sRGB changes nothing.
    EXPECT_TRUE(std::any_of(result.notes.begin(), result.notes.end(), [](const std::string& note) {
        return note.find("sRGB shaper left out") == 0;
    }));
}

TEST(Survey, finds_fitted_lattices_nearer_on_average_than_point_samples) {
    const Survey result =
        survey(recipe_of(test_looks()[3].f), small(), [](double, const std::string&) {});
    std::size_t pairs = 0;
    for (const SurveyRow& fitted : result.rows) {
        if (!fitted.what.fitted) {
            continue;
        }
        for (const SurveyRow& plain : result.rows) {
            Combination same = fitted.what;
            same.fitted = false;
            if (to_text(plain.what) == to_text(same)) {
                EXPECT_LT(fitted.error.absolute.mean, plain.error.absolute.mean)
                    << to_text(plain.what);
                ++pairs;
            }
        }
    }
    EXPECT_GT(pairs, 0u);
}

TEST(Survey, looks_at_the_own_shaper_of_a_look) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    Recipe recipe = recipe_of(test_looks()[3].f);
    Lut shaped = *recipe.base_lut;
    shaped.shaper = Lut1D{{{0, 0, 0}, {4, 4, 4}}, {}};
    for (int i = 0; i < 300; ++i) {
        const auto y = static_cast<float>(std::sqrt(i / 299.0));
        shaped.shaper->entries.push_back({y, y, y});
    }
    recipe.base_lut = std::make_shared<const Lut>(std::move(shaped));
    const Survey result = survey(recipe, small(), [](double, const std::string&) {});
    std::size_t own = 0, fitted = 0;
    for (const SurveyRow& row : result.rows) {
        if (row.what.shaper->name == "own") {
            ++(row.what.fitted ? fitted : own);
            const int n = row.what.size;
            EXPECT_EQ(row.bytes, static_cast<std::size_t>(n * n * n) * row.what.storage->bytes +
                                     300 * sizeof(Rgb));
            EXPECT_GT(row.pixel.median, 0);
        }
    }
    EXPECT_EQ(own, small().sizes.size() * storages().size() * lookups().size());
    EXPECT_GT(fitted, 0U);
    for (const std::string& note : result.notes) {
        EXPECT_EQ(note.find("its own shaper"), std::string::npos) << note;
    }
}

const SurveyRow& row_of(const Survey& result, int size, std::string_view storage,
                        const Lookup& lookup) {
    const auto row = std::find_if(result.rows.begin(), result.rows.end(), [&](const SurveyRow& r) {
        return r.what.size == size && r.what.storage->name == storage && r.what.lookup == &lookup &&
               !r.what.fitted && r.what.shaper->name == "none";
    });
    EXPECT_NE(row, result.rows.end());
    return *row;
}

// Leaves 0..1 on both sides.
RgbD contrast(RgbD c) {
    return 1.6 * c - RgbD{0.31, 0.31, 0.31};
}

TEST(Survey, clamps_as_a_display_does_and_agrees_with_what_bake_makes) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    const Recipe recipe = recipe_of(contrast);
    SurveySettings settings = small();
    settings.sizes = {16};
    const Survey result = survey(recipe, settings, [](double, const std::string&) {});
    EXPECT_TRUE(result.clamped);
    EXPECT_GT(result.outside.share, 0.4);
    EXPECT_NEAR(result.outside.most, 0.31, 2e-3); // of the colours looked at

    const Engine& engine = *engine_named("piccolo"); // trilinear
    const Transform look = Transform::of(recipe);
    const Bake picture = bake(look, engine, 16, 8);
    const std::vector<Rgb> inputs = error_samples({}, no_breaks(), settings.samples).even;
    const ErrorStats baked =
        compare(held_to_codes(look), read_by(engine, decoded(picture.picture), 16), inputs, srgb())
            .delta_e_2000;
    const SurveyRow& row = row_of(result, 16, "8", lookup_of(Interpolation::trilinear));
    EXPECT_NEAR(row.error.delta_e_2000.mean, baked.mean, 1e-4 * baked.mean);
    EXPECT_NEAR(row.error.delta_e_2000.p99, baked.p99, 1e-4 * baked.p99);
}

TEST(Survey, judges_what_no_display_shows_where_it_is_asked_to) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    SurveySettings settings = small();
    settings.unclamped = true;
    const Survey seen = survey(recipe_of(contrast), small(), [](double, const std::string&) {});
    const Survey all = survey(recipe_of(contrast), settings, [](double, const std::string&) {});
    EXPECT_FALSE(all.clamped);
    EXPECT_EQ(all.outside.share, seen.outside.share);
    const Lookup& lookup = lookup_of(Interpolation::tetrahedral);
    // Codes cannot hold what lies outside; floats can.
    EXPECT_NEAR(row_of(all, 9, "8", lookup).error.absolute.max, 0.31, 0.01);
    EXPECT_LT(row_of(seen, 9, "8", lookup).error.absolute.max, 0.06);
    EXPECT_LT(row_of(all, 9, "float", lookup).error.absolute.max, 1e-6);
}

TEST(Survey, tries_the_shaper_and_the_size_that_the_recipe_is_baked_with) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    Recipe recipe = recipe_of(test_looks()[3].f);
    recipe.bake.shaper = "tone";
    recipe.bake.shaper_size = 300;
    recipe.bake.size = 11;
    SurveySettings settings = small();
    settings.own_size = true;
    const Survey result = survey(recipe, settings, [](double, const std::string&) {});
    std::size_t found = 0;
    for (const SurveyRow& row : result.rows) {
        if (row.what.size == 11 && row.what.shaper->name == "tone") {
            ++found;
            EXPECT_EQ(row.bytes, 1331 * row.what.storage->bytes + 300 * sizeof(Rgb));
        }
    }
    EXPECT_GE(found, storages().size() * lookups().size());
}

TEST(Survey, progress_rises_to_the_end) {
    double last = 0;
    survey(recipe_of(test_looks()[0].f), small(), [&](double share, const std::string& doing) {
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1);
        EXPECT_FALSE(doing.empty());
        last = share;
    });
    EXPECT_EQ(last, 1);
}

SurveyRow row_with(double largest, std::size_t bytes, double seconds) {
    SurveyRow row;
    row.error.delta_e_2000.max = largest;
    row.bytes = bytes;
    row.pixel.median = seconds;
    return row;
}

TEST(Recommendation, is_the_smallest_that_keeps_the_promise_and_then_the_fastest) {
    const std::vector<SurveyRow> rows{row_with(0.5, 100, 3), row_with(2, 10, 1),
                                      row_with(0.9, 50, 2), row_with(0.8, 50, 1.5),
                                      row_with(0.1, 900, 1)};
    const Recommendation r = recommend(rows, 1);
    EXPECT_TRUE(r.kept);
    EXPECT_EQ(r.row, 3u);
    EXPECT_EQ(r.fastest, 4u);
    const Recommendation none = recommend(rows, 0.01);
    EXPECT_FALSE(none.kept);
    EXPECT_EQ(none.row, 4u);
}

TEST(Budget, keeps_its_promise_on_colors_that_it_has_not_seen) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    const Transform look = test_looks()[1].transform();
    for (const char* name : support::all_or<const char*>({"piccolo", "hald"}, {"piccolo"})) {
        const Engine& engine = *engine_named(name);
        // More is kept by fewer nodes, which sanitizers see as well.
        const double most = support::is_sanitized ? 6 : 2;
        const BudgetBake found =
            bake_within(look, engine, {most, std::nullopt, std::nullopt, true});
        ASSERT_TRUE(found.kept) << name;
        std::vector<Rgb> inputs =
            sample_colors(found.filled.bake.size,
                          {.neutral = 333, .random = 5000, .lattice = true, .skipped = 777777});
        const Bake& baked = found.filled.bake;
        const Difference error =
            compare(held_to_codes(look), read_by(engine, decoded(baked.picture), baked.size),
                    inputs, srgb());
        // The climb finds peaks nearly, not exactly.
        EXPECT_LE(error.delta_e_2000.max, most * 1.02) << name;
    }
}

} // namespace
} // namespace lutlib
