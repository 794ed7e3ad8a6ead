#include "lutlib/survey/precision.h"

#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace lutlib {
namespace {

Recipe plain_recipe(RgbD (*f)(RgbD)) {
    Lut lut;
    lut.cube = sampled(f, 9);
    Recipe recipe;
    recipe.base = "look";
    recipe.base_lut = std::make_shared<const Lut>(std::move(lut));
    return recipe;
}

SurveyReference reference_of(const Recipe& recipe) {
    SurveySettings settings;
    settings.samples.even = 800;
    return {recipe, settings};
}

TEST(Precision, rises_with_bits_and_is_what_rounding_makes_it) {
    const Recipe recipe = plain_recipe(test_looks()[1].f);
    const std::vector<PrecisionRow> rows = precision_of(reference_of(recipe));
    std::map<std::string, double> ulp;
    for (const PrecisionRow& row : rows) {
        if (row.lookup == "tetrahedral") {
            ulp[row.storage + "/" + row.arithmetic] = row.ulp.max;
        }
    }
    // Halves have 13 bits of mantissa less than floats.
    EXPECT_GT(ulp.at("half/double"), 1024);
    EXPECT_LE(ulp.at("half/double"), 8192);
    // Results of 0.5 to 1 have last places of 2^-24, and a code of 8 bits is 2^24/255 of them.
    EXPECT_GE(ulp.at("8 bits/double"), 0.3 * 16777216 / 255);
    EXPECT_LT(ulp.at("float/double"), 2);
    EXPECT_LT(ulp.at("float/float"), 16);
    EXPECT_GT(ulp.at("half/half"), ulp.at("half/double"));
    EXPECT_GT(ulp.at("float/float, 8 fraction bits"), 1000);
    for (const char* pair : {"8 bits 10 bits", "10 bits 12 bits", "12 bits 16 bits"}) {
        const std::string both = pair, coarse = both.substr(0, both.find(" bits") + 5);
        const std::string fine = both.substr(coarse.size() + 1);
        EXPECT_GT(ulp.at(coarse + "/double"), 3 * ulp.at(fine + "/double")) << pair;
    }
}

TEST(Sensitivity, of_a_look_twice_as_steep_is_twice_as_large) {
    // Both end near middle grey, where equal changes of codes are equal to the eye.
    const Recipe steep = plain_recipe([](RgbD c) { return 0.02 * c + RgbD{0.49, 0.49, 0.49}; });
    const Recipe flat = plain_recipe([](RgbD c) { return 0.01 * c + RgbD{0.495, 0.495, 0.495}; });
    const std::vector<SensitivityRow> of_steep = sensitivity_of(reference_of(steep)),
                                      of_flat = sensitivity_of(reference_of(flat));
    ASSERT_EQ(of_steep.size(), 3U);
    EXPECT_NEAR(of_steep[0].p50 / of_flat[0].p50, 2, 0.2);
    // Four times as many codes, a quarter of the error.
    EXPECT_NEAR(of_steep[0].p50 / of_steep[1].p50, 1023.0 / 255, 0.1);
    EXPECT_LE(of_steep[0].p50, of_steep[0].delta_e.p99);
    EXPECT_LE(of_steep[0].delta_e.p99, of_steep[0].delta_e.max);
}

TEST(Noise, gain_is_the_slope_of_the_look) {
    const Recipe half = plain_recipe([](RgbD c) { return 0.5 * c + RgbD{0.25, 0.25, 0.25}; });
    const std::vector<NoiseRow> rows = noise_of(reference_of(half));
    ASSERT_EQ(rows.size(), 11U);
    for (const NoiseRow& row : rows) {
        if (row.light > 0.01 && row.light < 0.9) { // no clipping
            EXPECT_NEAR(row.gain, 0.5, 1e-3) << row.light;
        }
    }
    // At light 1 the deviation is the root of 30025 electrons in 30000, and sRGB's slope there
    // 1.055 / 2.4; half of the noise is clipped away.
    EXPECT_NEAR(rows.back().in, std::sqrt(30025.0) / 30000 * 1.055 / 2.4, 2e-4);
}

TEST(Chains, lose_little_in_floats_and_more_in_codes_and_come_back_by_the_inverse) {
    const Recipe recipe = plain_recipe([](RgbD c) {
        const auto bend = [](double x) { return 0.8 * x + 0.2 * x * x; };
        return RgbD{bend(c.r), bend(c.g), bend(c.b)};
    });
    const std::vector<ChainRow> rows = chains_of(reference_of(recipe));
    const auto row = [&](const std::string& what, const std::string& between) {
        const auto found = std::find_if(rows.begin(), rows.end(), [&](const ChainRow& r) {
            return r.what == what && r.between == between;
        });
        EXPECT_NE(found, rows.end()) << what << " " << between;
        return found == rows.end() ? 0 : found->delta_e.mean;
    };
    for (const char* chain : {"1 look", "2 looks in turn", "8 looks in turn", "look and inverse"}) {
        EXPECT_GT(row(chain, "8 bits"), 3 * row(chain, "16 bits")) << chain;
        EXPECT_LT(row(chain, "float"), 0.3) << chain;
    }
    EXPECT_GT(row("8 looks in turn", "8 bits"), row("1 look", "8 bits"));
    EXPECT_LT(row("2 looks as one lattice", "nothing"), 0.1);
    // A look that gives other codes than it takes makes no chain.
    Recipe other = recipe;
    other.output = encoding_named("gamma24");
    EXPECT_TRUE(chains_of(reference_of(other)).empty());
}

} // namespace
} // namespace lutlib
