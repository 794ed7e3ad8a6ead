#include "lutlib/health/health.h"
#include "lutlib/health/jacobian.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/survey/stiff_suite.h"
#include "tests/lutlib/looks.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

namespace lutlib {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Lut look(RgbD (*f)(RgbD), int size) {
    Lut lut;
    lut.cube = sampled(f, size);
    return lut;
}

Health of_suite(std::string_view name) {
    return examine(stiff_look_named(name)->make());
}

const HealthCheck& check_named(std::string_view name) {
    for (const HealthCheck& check : health_checks()) {
        if (check.name == name) {
            return check;
        }
    }
    throw std::runtime_error("no such check");
}

TEST(Jacobian, has_the_singular_values_of_rotated_diagonal_matrices) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> angle(0, 6.28), log_value(-4, 1);
    for (int i = 0; i < 1000; ++i) {
        const double s[] = {10, std::pow(10, log_value(random)), std::pow(10, log_value(random))};
        Jacobian j{RgbD{s[0], 0, 0}, RgbD{0, s[1], 0}, RgbD{0, 0, s[2]}};
        // Turning rows or columns about any axis changes no singular value.
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double a = angle(random), c = std::cos(a), n = std::sin(a);
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (RgbD& column : j) {
                const double x = column[u], y = column[v];
                column[u] = c * x - n * y;
                column[v] = n * x + c * y;
            }
            const RgbD p = j[u], q = j[v];
            j[u] = c * p + n * q;
            j[v] = c * q + -n * p;
        }
        const SingularValues got = singular_values(j);
        const double smallest = std::min({s[0], s[1], s[2]});
        EXPECT_NEAR(got.largest, std::max({s[0], s[1], s[2]}), 1e-9);
        // The cofactors' rounding, 1e-16 of the largest entry's square, against s2 * s3 >= 1e-8.
        EXPECT_NEAR(got.smallest, smallest, 1e-5 * smallest);
    }
    EXPECT_EQ(singular_values({}).largest, 0);
    EXPECT_NEAR(singular_values({RgbD{1e38, 0, 0}, RgbD{0, 1e38, 0}, RgbD{0, 0, 1e38}}).smallest,
                1e38, 1e24);
}

TEST(Health, finds_nothing_wrong_with_the_identity) {
    const Health h = of_suite("identity");
    EXPECT_EQ(verdict(h), Severity::good);
    EXPECT_EQ(h.tetrahedra, 6U * 32 * 32 * 32);
    EXPECT_NEAR(h.gain.value, 1, 1e-9);
    EXPECT_NEAR(h.condition.value, 1, 1e-6);
    EXPECT_NEAR(h.invertible, 1, 1e-9);
    EXPECT_NEAR(h.banding_neutral.value, 1, 1e-5);
    EXPECT_NEAR(h.noise_gain.value, 1, 1e-4);
    EXPECT_LT(h.lattices[0].code.max, 1e-6);
    EXPECT_LT(h.lattices[1].code.max, 1e-6);
}

TEST(Health, of_a_look_without_tables_is_the_identitys) {
    EXPECT_EQ(verdict(examine(Lut{})), Severity::good);
}

TEST(Health, counts_the_tetrahedra_that_fold_and_says_where) {
    const Health folded = of_suite("folded");
    EXPECT_EQ(folded.folded, folded.tetrahedra / 2);
    EXPECT_GT(folded.deepest_fold.in.r, 0.5F);
    EXPECT_NEAR(folded.deepest_fold.value, 2, 1e-5);
    EXPECT_NEAR(folded.invertible, 0.5, 1e-9);
    for (const char* name : {"swapped", "inverted"}) {
        const Health mirror = of_suite(name);
        EXPECT_EQ(mirror.folded, 0U) << name;
        EXPECT_TRUE(mirror.mirrored) << name;
        EXPECT_NEAR(mirror.invertible, 1, 1e-9) << name;
    }
    EXPECT_FALSE(of_suite("permuted").mirrored);
}

TEST(Health, calls_a_cube_flat_only_where_rounding_could_hide_its_sign) {
    EXPECT_EQ(of_suite("constant_grey").invertible, 0);
    // Five per cent of saturation is little, but larger than six decimals' rounding.
    const Health dull = examine(look(
        [](RgbD c) {
            const double y = test_luma(c);
            return RgbD{y + 0.05 * (c.r - y), y + 0.05 * (c.g - y), y + 0.05 * (c.b - y)};
        },
        17));
    EXPECT_EQ(dull.flat, 0U);
    EXPECT_EQ(dull.folded, 0U);
}

// 0..4 becomes the cube's -1..2, so that node k is reached by input k.
TEST(Health, says_where_nodes_are_as_inputs_before_the_shaper) {
    Lut lut = look([](RgbD c) { return c; }, 5);
    lut.cube->domain = {{-1, -1, -1}, {2, 2, 2}};
    lut.shaper = Lut1D{{{0, 0, 0}, {4, 4, 4}}, {{-1, -1, -1}, {2, 2, 2}}};
    lut.cube->at(1, 2, 3).g = 9;
    lut.cube->at(3, 0, 1).b = -9;
    Health h = examine(lut);
    EXPECT_EQ(h.highest.in, (Rgb{1, 2, 3}));
    EXPECT_EQ(h.lowest.in, (Rgb{3, 0, 1}));
    lut.cube->at(3, 0, 1).b = 0.25F;
    h = examine(lut);
    EXPECT_EQ(h.second_difference.in, (Rgb{1, 2, 3}));
    lut.cube->at(4, 3, 0).r = nan;
    EXPECT_EQ(examine(lut).first_non_finite, (Rgb{4, 3, 0}));
    // Through a table that falls, and one that never reaches the node.
    lut.shaper->entries = {{2, 2, 2}, {-1, -1, -1}};
    EXPECT_EQ(examine(lut).first_non_finite, (Rgb{0, 1, 4}));
    lut.shaper->entries = {{0, 2, 2}, {1, -1, -1}};
    EXPECT_EQ(examine(lut).first_non_finite, (Rgb{4, 1, 4}));
}

TEST(Health, finds_the_steepest_place) {
    const Health spike = of_suite("spike_100");
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(spike.gain.in[c], 0.5, 1.0 / 32);
        EXPECT_NEAR(spike.second_difference.in[c], 0.5, 1e-6);
    }
    const Health shoulder = of_suite("shoulder_16");
    EXPECT_NEAR(shoulder.gain.value, stiff_look_named("shoulder_16")->stiffness, 1e-4);
    EXPECT_NEAR(shoulder.gain.in.r, 0.5, 1.0 / 64);
}

TEST(Health, multiplies_the_slopes_of_a_1d_table_and_its_cube) {
    // The edges of the cube gain 1.4639 along blue at most; no direction can gain less.
    const Health h = of_suite("shaped_log");
    EXPECT_GE(h.gain.value, 0.999 * stiff_look_named("shaped_log")->stiffness);
    EXPECT_LT(h.gain.in.b, 1e-3F);
    EXPECT_NEAR(h.invertible, 1, 1e-6);
    EXPECT_NEAR(of_suite("shoulder_1000").gain.value, stiff_look_named("shoulder_1000")->stiffness,
                1e-2);
}

TEST(Health, finds_where_a_channel_begins_to_clip) {
    const Health h = examine(look([](RgbD c) { return saturate(RgbD{2 * c.r, c.g, c.b}); }, 33));
    EXPECT_NEAR(h.clipped_high[0].value, 0.5, 1e-9);
    EXPECT_NEAR(h.clipped_high[0].in.r, 0.5 + 0.5 / 32, 1e-6);
    EXPECT_EQ(h.clipped_high[1].value, 0);
    EXPECT_EQ(h.plateau.value, 0);
    EXPECT_NEAR(h.invertible, 0.5, 1e-9);
    EXPECT_GT(of_suite("posterised").plateau.value, 0.4);
}

TEST(Health, leaves_values_that_are_no_numbers_out_of_every_other_figure) {
    Lut lut;
    lut.cube = identity_cube(9);
    lut.cube->at(4, 4, 4) = {nan, 0.5F, std::numeric_limits<float>::infinity()};
    const Health h = examine(lut);
    EXPECT_EQ(h.non_finite, 2U);
    EXPECT_EQ(h.first_non_finite, (Rgb{0.5F, 0.5F, 0.5F}));
    EXPECT_EQ(verdict(h), Severity::fault);
    EXPECT_NEAR(h.gain.value, 1, 1e-6);
    EXPECT_EQ(h.highest.value, 1);
    EXPECT_EQ(h.tetrahedra, 6U * (512 - 8));
}

TEST(Health, finds_the_single_nodes_that_a_repair_levels) {
    Lut lut;
    lut.cube = identity_cube(9);
    EXPECT_EQ(examine(lut).spikes, 0U);
    lut.cube->nodes[lut.cube->index(4, 2, 6)].g = 5;
    lut.cube->nodes[0].r = -3;
    const Health health = examine(lut);
    EXPECT_EQ(health.spikes, 2U);
    EXPECT_NEAR(health.largest_spike.value, 4.75, 1e-6);
    EXPECT_EQ(health.largest_spike.in, (Rgb{0.5F, 0.25F, 0.75F}));
}

TEST(Health, judges_the_neutral_axis) {
    Lut dip;
    dip.cube = identity_cube(17);
    dip.cube->at(8, 8, 8) = {0.3F, 0.3F, 0.3F};
    const Health h = examine(dip);
    EXPECT_NEAR(h.neutral_fall.value, 7.0 / 16 - 0.3, 1e-6);
    EXPECT_NEAR(h.neutral_fall.in.g, 0.5, 1e-6);
    const HealthCheck& check = check_named("neutral-axis");
    EXPECT_EQ(check.judge(h).severity, Severity::fault);
    EXPECT_EQ(check.judge(of_suite("inverted")).severity, Severity::fault);
    EXPECT_EQ(check.judge(of_suite("shoulder_8")).severity, Severity::good);
}

TEST(Health, finds_a_1d_table_that_turns_back) {
    Lut lut;
    lut.shaper = Lut1D{{}, {{0, 0, 0}, {0.5F, 0.6F, 0.5F}, {0.7F, 0.4F, 0.7F}, {1, 1, 1}}};
    const Health h = examine(lut);
    EXPECT_NEAR(h.shaper_fall[1].value, 0.2, 1e-6);
    EXPECT_NEAR(h.shaper_fall[1].in.g, 1.0 / 3, 1e-6);
    EXPECT_EQ(h.shaper_fall[0].value, 0);
    EXPECT_EQ(check_named("1d-table").judge(h).severity, Severity::fault);
}

// What really happens to a ramp of 256 codes.
double measured_banding(const Lut& lut) {
    double most = 0, last = 0;
    for (int code = 0; code < 256; ++code) {
        const double v = code / 255.0;
        const double out = std::round(255 * evaluate_exact(lut, {v, v, v}).g);
        most = code ? std::max(most, std::abs(out - last)) : 0;
        last = out;
    }
    return most;
}

TEST(Health, predicts_the_banding_of_an_8_bit_ramp_within_a_code) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    for (const char* name : {"identity", "shoulder_2", "shoulder_8", "shoulder_16", "gain_1000",
                             "step", "step_fine"}) {
        const Lut lut = stiff_look_named(name)->make();
        EXPECT_NEAR(examine(lut).banding_neutral.value, measured_banding(lut), 1) << name;
    }
}

TEST(Health, predicts_what_noise_near_black_becomes) {
    const Lut lut = look(
        [](RgbD c) {
            const double y = test_luma(c);
            const auto lifted = [y](double v) { return std::cbrt(0.01 + y + 1.5 * (v - y)); };
            return RgbD{lifted(c.r), lifted(c.g), lifted(c.b)};
        },
        65);
    const Health h = examine(lut);
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 0.2 / 255);
    const RgbD centre = to_double(h.noise_gain.in);
    const RgbD clean = evaluate_exact(lut, centre);
    RgbD square;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i) {
        const RgbD in = centre + RgbD{noise(random), noise(random), noise(random)};
        const RgbD d = evaluate_exact(lut, in) - clean;
        square = square + RgbD{d.r * d.r, d.g * d.g, d.b * d.b};
    }
    const double most = std::sqrt(largest_magnitude(square) / count);
    EXPECT_NEAR(h.noise_gain.value, most / (0.2 / 255), 0.1 * h.noise_gain.value);
    EXPECT_LT(centre.r, 17.0 / 255);
}

TEST(Health, of_a_black_and_white_look_is_good_though_nothing_inverts_it) {
    const Health h = examine(look(
        [](RgbD c) {
            const double y = test_luma(c);
            return RgbD{y, y, y};
        },
        17));
    EXPECT_EQ(h.invertible, 0);
    EXPECT_EQ(check_named("invertible").judge(h).severity, Severity::note);
    EXPECT_LT(verdict(h), Severity::fault);
}

// Of light and of camera log nobody looks at the codes; PQ is judged by its own steps.
TEST(Health, judges_bands_by_what_the_results_are_for) {
    const auto steep = [](RgbD c) { return RgbD{12 * c.r * c.r, 12 * c.g * c.g, 12 * c.b * c.b}; };
    const auto judged = [&](const char* output) {
        const LookEncodings codes{{}, encoding_named(output)};
        return check_named("banding").judge(examine(look(steep, 33), {.encodings = codes}));
    };
    EXPECT_GE(judged("srgb").severity, Severity::warning);
    EXPECT_EQ(judged("linear").severity, Severity::good);
    EXPECT_EQ(judged("logc3").severity, Severity::good);
    EXPECT_NE(judged("pq").words.find("dE-ITP"), std::string::npos) << judged("pq").words;
    EXPECT_NE(judged("pq").words.find("10 bits"), std::string::npos);
    // An sRGB ramp of 8 bits is made so that its steps are not seen.
    EXPECT_LT(examine(look([](RgbD c) { return c; }, 17)).banding_to_eye.value, 1);
}

TEST(Health, tells_what_coarse_lattices_miss_as_the_eye_sees_it) {
    const Health h = examine(look([](RgbD c) { return RgbD{c.r * c.r, c.g, c.b}; }, 25));
    EXPECT_NE(check_named("error-at-33").judge(h).words.find("dE2000"), std::string::npos);
}

TEST(Health, says_how_steep_a_look_usually_is_beside_the_steepest_place) {
    // Gain 1 but in one cell in 16 of red, where it is 9.
    const Health h = examine(look(
        [](RgbD c) {
            return RgbD{c.r + 8 * std::clamp(c.r - 0.5, 0.0, 1.0 / 16), c.g, c.b};
        },
        17));
    EXPECT_NEAR(h.gain_spread.p50, 1, 1e-5);
    EXPECT_NEAR(h.gain_spread.p99, 9, 1e-4);
    EXPECT_NEAR(h.gain.value, 9, 1e-4);
    EXPECT_NEAR(h.condition_spread.p50, 1, 1e-4);
    EXPECT_NEAR(h.condition.value, 9, 1e-3);
}

class HealthOfStiffLook : public testing::TestWithParam<StiffLook> {};
// Under sanitizers every fourth, which walks the same code.
std::vector<StiffLook> stiff_looks() {
    std::vector<StiffLook> out;
    const std::size_t step = support::is_sanitized ? 4 : 1;
    for (std::size_t i = 0; i < stiff_suite().size(); i += step) {
        out.push_back(stiff_suite()[i]);
    }
    return out;
}
INSTANTIATE_TEST_SUITE_P(Suite, HealthOfStiffLook, testing::ValuesIn(stiff_looks()),
                         [](const auto& row) { return std::string(row.param.name); });

// Examined once, as the largest are slow.
const Health& health_of(const StiffLook& look) {
    static std::map<std::string_view, Health> known;
    const auto [row, is_new] = known.try_emplace(look.name);
    if (is_new) {
        row->second = examine(look.make());
    }
    return row->second;
}

TEST_P(HealthOfStiffLook, has_a_finite_figure_and_words_for_every_check) {
    const Lut lut = GetParam().make();
    const Health& h = health_of(GetParam());
    for (const HealthCheck& check : health_checks()) {
        const Finding finding = check.judge(h);
        EXPECT_TRUE(std::isfinite(finding.figure)) << check.name << ": " << finding.words;
        EXPECT_FALSE(finding.words.empty()) << check.name;
        EXPECT_EQ(finding.words.find("nan"), std::string::npos) << finding.words;
        EXPECT_EQ(finding.words.find("inf"), std::string::npos) << finding.words;
        for (std::size_t c = 0; finding.where && c < 3; ++c) {
            EXPECT_GE((*finding.where)[c], lut.domain().min[c]) << check.name;
            EXPECT_LE((*finding.where)[c], lut.domain().max[c]) << check.name;
        }
    }
    EXPECT_GE(h.invertible, 0);
    EXPECT_LE(h.invertible, 1 + 1e-6);
    EXPECT_GE(h.gain.value, 0.99 * GetParam().stiffness);
}

TEST(HealthChecks, have_names_of_their_own_and_each_speaks_up_for_some_look) {
    if (support::is_sanitized) {
        GTEST_SKIP() << "HealthOfStiffLook examines the suite's looks here, a test each";
    }
    std::vector<Health> all;
    for (const StiffLook& row : stiff_suite()) {
        const Lut lut = row.make();
        if (!lut.cube || lut.cube->size < 40) {
            all.push_back(health_of(row));
        }
    }
    Lut broken;
    broken.cube = identity_cube(3);
    broken.cube->nodes[5] = {nan, nan, nan};
    broken.shaper = Lut1D{{}, {{0, 0, 0}, {2, 2, 2}, {1, 1, 1}, {3, 3, 3}}};
    all.push_back(examine(broken));
    std::set<std::string_view> names;
    for (const HealthCheck& check : health_checks()) {
        EXPECT_TRUE(names.insert(check.name).second);
        std::set<std::string> words;
        for (const Health& health : all) {
            words.insert(check.judge(health).words);
        }
        EXPECT_GT(words.size(), 1U) << check.name << " says the same of every look";
    }
}

} // namespace
} // namespace lutlib
