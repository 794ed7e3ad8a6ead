#include "lutlib/metrics/compare.h"

#include "lutlib/color/difference.h"
#include "lutlib/engine/engine.h"
#include "lutlib/interpolation/interpolation.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace lutlib {
namespace {

using support::is_thorough;

// A search that knows nothing of nodes: random colours, more at the domain's ends, and from the
// worst of them random steps, wide and narrow.
double found_by_force(const Transform& a, const Transform& b, const Domain& domain,
                      const std::function<double(RgbD, RgbD)>& distance) {
    const auto error_at = [&](Rgb in) { return distance(a(to_double(in)), b(to_double(in))); };
    const std::size_t tasks = 64, colors = is_thorough() ? 20'000 : 1500;
    std::vector<double> largest(tasks);
    tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
        std::mt19937 random(static_cast<unsigned>(task) + 1);
        std::uniform_real_distribution<float> beyond(-0.1F, 1.1F), sign(-1, 1);
        std::vector<std::pair<double, Rgb>> found(colors);
        const auto held = [&](Rgb place) {
            for (std::size_t c = 0; c < 3; ++c) {
                place[c] = std::clamp(place[c], domain.min[c], domain.max[c]);
            }
            return place;
        };
        for (auto& [error, in] : found) {
            for (std::size_t c = 0; c < 3; ++c) {
                in[c] = std::lerp(domain.min[c], domain.max[c], beyond(random));
            }
            in = held(in);
            error = error_at(in);
        }
        const std::ptrdiff_t best = is_thorough() ? 20 : 6;
        std::partial_sort(found.begin(), found.begin() + best, found.end(),
                          [](const auto& x, const auto& y) { return x.first > y.first; });
        for (std::ptrdiff_t k = 0; k < best; ++k) {
            auto [error, at] = found[static_cast<std::size_t>(k)];
            for (int step = 0; step < 400; ++step) {
                const float reach = std::exp2(-3 - static_cast<float>(step % 12));
                Rgb next = at;
                for (std::size_t c = 0; c < 3; ++c) {
                    next[c] += sign(random) * reach * (domain.max[c] - domain.min[c]);
                }
                next = held(next);
                if (const double now = error_at(next); now > error) {
                    error = now;
                    at = next;
                }
            }
            largest[task] = std::max(largest[task], error);
        }
    });
    return *std::max_element(largest.begin(), largest.end());
}

double code_distance(RgbD a, RgbD b) {
    return largest_magnitude(a - b);
}

double eye_distance(RgbD a, RgbD b) {
    return delta_e_2000(a, b);
}

struct Case {
    std::string name;
    Lut look;
    Interpolation read;
    int lattice;
    Interpolation lookup;
};

// Nodes as real looks have them, smooth with some noise, over any domain.
Lut3D family_cube(int size, unsigned seed, float noise, const Domain& domain) {
    Lut3D cube = identity_cube(size, domain);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    const Rgb wave{uniform(random), uniform(random), uniform(random)};
    const float width = domain.max.r - domain.min.r;
    for (Rgb& node : cube.nodes) {
        const Rgb x = (node - domain.min) * (1 / width);
        for (std::size_t c = 0; c < 3; ++c) {
            const float bent = x[c] + 0.2F * wave[c] * std::sin(6 * x[(c + 1) % 3] + 3 * x[c]) +
                               noise * uniform(random);
            node[c] = saturate(bent);
        }
    }
    return cube;
}

std::vector<Case> family() {
    std::vector<Case> out;
    unsigned seed = 1;
    const auto add = [&](int size, int lattice, Interpolation read, Interpolation lookup,
                         float noise, const Domain& domain, bool shaped) {
        Case c{"", {}, read, lattice, lookup};
        c.name = std::to_string(size) + " nodes on " + std::to_string(lattice) + ", look " +
                 std::to_string(seed);
        c.look.cube = family_cube(size, seed++, noise, shaped ? Domain{} : domain);
        if (shaped) {
            Lut1D table{domain, {}};
            for (int i = 0; i < 9; ++i) {
                const float x = static_cast<float>(i) / 8;
                table.entries.push_back({x * x, std::sqrt(x), x});
            }
            c.look.shaper = table;
        }
        out.push_back(std::move(c));
    };
    const auto four = Interpolation::tetrahedral, eight = Interpolation::trilinear;
    const Domain wide{{-0.5F, -0.5F, -0.5F}, {2, 2, 2}};
    add(17, 16, four, eight, 0, {}, false);
    add(12, 12, four, eight, 0.02F, {}, false);
    if (is_thorough()) {
        add(17, 64, four, eight, 0.05F, {}, false);
        add(9, 6, eight, eight, 0.05F, {}, false);
        add(33, 16, four, eight, 0.01F, {}, false);
        add(33, 25, four, four, 0.01F, {}, false);
        add(32, 33, eight, four, 0.003F, {}, false);
        add(64, 16, four, eight, 0, {}, false);
        add(25, 17, four, eight, 0, wide, false);
        add(17, 8, eight, four, 0.02F, wide, true);
        add(9, 7, Interpolation::nearest, eight, 0.05F, {}, false);
        add(2, 5, eight, four, 0.3F, {}, false);
    }
    add(9, 8, four, eight, 0.01F, wide, true);
    return out;
}

TEST(Measure, finds_the_largest_error_of_a_family_of_looks_within_two_percent) {
    for (const Case& c : family()) {
        const Domain domain = c.look.domain();
        const Transform look = Transform::of(c.look, c.read);
        Lut baked;
        baked.cube = identity_cube(c.lattice, domain);
        for (Rgb& node : baked.cube->nodes) {
            const RgbD right = look(to_double(node));
            for (std::size_t k = 0; k < 3; ++k) {
                node[k] = std::round(static_cast<float>(right[k]) * 255) / 255;
            }
        }
        const Transform lookup = Transform::of(baked, c.lookup);
        const ErrorSamples samples =
            error_samples(domain, united(breaks_of(c.look, c.read), breaks_of(baked, c.lookup)));
        EXPECT_TRUE(samples.whole) << c.name;
        const Difference d = measure(look, lookup, samples, srgb());
        EXPECT_GE(d.absolute.max, 0.98 * found_by_force(look, lookup, domain, code_distance))
            << c.name;
        EXPECT_GE(d.delta_e_2000.max, 0.98 * found_by_force(look, lookup, domain, eye_distance))
            << c.name;
        // And that it is an error of that very colour.
        ASSERT_TRUE(d.delta_e_2000.at);
        EXPECT_NEAR(eye_distance(look(to_double(*d.delta_e_2000.at)),
                                 lookup(to_double(*d.delta_e_2000.at))),
                    d.delta_e_2000.max, 1e-9);
    }
}

struct Spike {
    int size, lattice;
    std::array<int, 3> node;
    Rgb pushed;
};

// The node that breaks a promise by number alone, and some anywhere.
std::vector<Spike> spikes() {
    std::vector<Spike> out{{33, 97, {0, 1, 1}, {0, -0.017F, 0.033F}},
                           {17, 33, {8, 3, 5}, {0, 0, 0.03F}}};
    std::mt19937 random(3);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    std::uniform_real_distribution<float> by(-0.05F, 0.05F);
    for (int i = 0; is_thorough() && i < 30; ++i) {
        const int size = std::array{17, 25, 33}[static_cast<std::size_t>(i) % 3];
        const int lattice =
            std::array{2 * size - 1, 3 * size - 2, 64, 41, 16}[static_cast<std::size_t>(i) % 5];
        out.push_back({size,
                       lattice,
                       {below(size), below(size), below(size)},
                       {by(random), by(random), by(random)}});
    }
    return out;
}

TEST(Measure, finds_the_largest_error_beside_a_single_wrong_node) {
    const std::vector<Spike> all = spikes();
    for (const Spike& spike : all) {
        Lut look, baked;
        look.cube = identity_cube(spike.size);
        const auto [r, g, b] = spike.node;
        Rgb& wrong = look.cube->nodes[look.cube->index(r, g, b)];
        Domain around;
        for (std::size_t c = 0; c < 3; ++c) {
            const float cell = 1 / static_cast<float>(spike.size - 1);
            around.min[c] = std::max(0.0F, wrong[c] - cell);
            around.max[c] = std::min(1.0F, wrong[c] + cell);
        }
        wrong = saturate(wrong + spike.pushed);
        const Transform right = Transform::of(look);
        baked.cube = identity_cube(spike.lattice);
        for (Rgb& node : baked.cube->nodes) {
            const RgbD code = right(to_double(node)) * 255;
            node = to_float(RgbD{std::round(code.r), std::round(code.g), std::round(code.b)} *
                            (1 / 255.0));
        }
        const Transform lookup = Transform::of(baked, Interpolation::trilinear);
        ErrorSamples samples =
            error_samples({}, united(breaks_of(look), breaks_of(baked, Interpolation::trilinear)));
        const double found = found_by_force(right, lookup, around, eye_distance);
        const auto largest = [&] {
            return largest_difference(right, lookup, samples, srgb(), Metric::delta_e_2000).error;
        };
        EXPECT_GE(largest(), 0.98 * found) << spike.size << " nodes on " << spike.lattice;
        if (&spike == &all.front()) {
            samples.suspects = {};
            EXPECT_LT(largest(), 0.95 * found) << "a choice by number finds it too";
        }
    }
}

TEST(Measure, takes_means_and_percentiles_of_evenly_spread_colors_alone) {
    Lut look;
    look.cube = family_cube(9, 3, 0.05F, {});
    const Transform a = Transform::of(look, Interpolation::trilinear), b;
    const Difference d =
        measure(a, b, error_samples({}, breaks_of(look, Interpolation::trilinear)), srgb());
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    double sum = 0;
    constexpr int count = 200'000;
    for (int i = 0; i < count; ++i) {
        const RgbD in{uniform(random), uniform(random), uniform(random)};
        sum += code_distance(a(in), in);
    }
    EXPECT_NEAR(d.absolute.mean, sum / count, 0.005 * d.absolute.mean);
    EXPECT_EQ(d.absolute.count, SampleLimits{}.even);
    EXPECT_GT(d.absolute.max, d.absolute.p99);
}

// What lattices of 15 and 31 cells differ by is a sum of waves, 15a + 31b to a channel. The
// sequence alone is in step with the first of these: there its mean is 0.6.
TEST(ErrorSamples, of_even_spread_are_in_step_with_no_waves_of_two_lattices) {
    const std::vector<Rgb> even = error_samples({}, no_breaks()).even;
    for (const RgbD wave : {RgbD{63, 48, -107}, RgbD{30, 77, -15}, RgbD{138, -32, -92}}) {
        double cosines = 0, sines = 0;
        for (const Rgb& at : even) {
            const double turns = wave.r * static_cast<double>(at.r) +
                                 wave.g * static_cast<double>(at.g) +
                                 wave.b * static_cast<double>(at.b);
            cosines += std::cos(2 * std::numbers::pi * turns);
            sines += std::sin(2 * std::numbers::pi * turns);
        }
        const auto count = static_cast<double>(even.size());
        // Six standard deviations of colours that are chosen at random.
        EXPECT_LT(std::hypot(cosines, sines) / count, 6 / std::sqrt(count)) << wave.r;
    }
}

TEST(ErrorSamples, hold_every_color_of_a_union_grid_that_is_small_enough) {
    Lut look;
    look.cube = identity_cube(5);
    const Breaks both =
        united(breaks_of(look, Interpolation::trilinear), breaks_of(reader_of(engines()[0], 4)));
    const ErrorSamples samples = error_samples({}, both);
    EXPECT_TRUE(samples.whole);
    // Quarters and thirds.
    EXPECT_EQ(samples.axis[0].size(), 7U);
    std::size_t found = 0;
    for (const float b : samples.axis[2]) {
        for (const float r : samples.axis[0]) {
            const Rgb wanted{r, samples.axis[1][3], b};
            found += std::find(samples.hiding.begin(), samples.hiding.end(), wanted) !=
                     samples.hiding.end();
        }
    }
    EXPECT_EQ(found, 49U);
    EXPECT_FALSE(error_samples({}, both, {.grid = 300}).whole);
    EXPECT_FALSE(error_samples({}, no_breaks()).whole);
}

TEST(Breaks, of_a_shaped_cube_lie_where_the_table_meets_its_nodes) {
    Lut look;
    look.shaper = Lut1D{{{0, 0, 0}, {4, 4, 4}}, {{0, 0, 0}, {0.25F, 1, 1}, {1, 1, 1}}};
    look.cube = identity_cube(3);
    const Breaks breaks = breaks_of(look, Interpolation::trilinear);
    // Red reaches the middle node a third of the way from 2 to 4.
    ASSERT_EQ(breaks.at[0].size(), 4U);
    EXPECT_NEAR(breaks.at[0][2], 2 + 2.0 / 3, 1e-6);
    EXPECT_NEAR(breaks.at[1][1], 1, 1e-6);
    EXPECT_TRUE(breaks.all);
}

TEST(Breaks, of_an_engine_are_where_its_lookup_reads_nodes) {
    for (const Engine& engine : engines()) {
        const int size = engine.default_size;
        const Breaks breaks = breaks_of(reader_of(engine, size));
        for (int i = 0; i < size; ++i) {
            const double node = engine.node_input(i, size);
            const bool met = std::any_of(breaks.at[1].begin(), breaks.at[1].end(),
                                         [&](double x) { return std::abs(x - node) < 1e-6; });
            EXPECT_TRUE(met) << engine.name << " node " << i;
        }
        EXPECT_LE(breaks.at[1].size(), static_cast<std::size_t>(size) + 2) << engine.name;
    }
}

TEST(Viewing, takes_pq_codes_as_the_light_that_they_say) {
    const Encoding pq = require_encoding("pq");
    const std::vector<RgbD> a{{0.5, 0.5, 0.5}}, b{{0.51, 0.5, 0.5}};
    std::vector<double> at_203(1), at_100(1);
    Eye({pq, 203})(Metric::delta_e_itp, a, b, at_203);
    Eye({pq, 100})(Metric::delta_e_itp, a, b, at_100);
    EXPECT_EQ(at_203[0], at_100[0]);
    // Grey of 203 cd/m2 is white: BT.2408 has it at the code 0.58.
    std::vector<double> to_srgb(1);
    Eye({pq, 203})(Metric::delta_e_2000, std::vector<RgbD>{{0.5807, 0.5807, 0.5807}},
                   std::vector<RgbD>{{0, 0, 0}}, to_srgb);
    EXPECT_NEAR(to_srgb[0], 100, 0.1);
    // In a relative encoding the white counts.
    Eye({srgb(), 203})(Metric::delta_e_itp, a, b, at_203);
    Eye({srgb(), 100})(Metric::delta_e_itp, a, b, at_100);
    EXPECT_GT(at_203[0], 1.05 * at_100[0]);
}

} // namespace
} // namespace lutlib
