#include "lutlib/fit/fit.h"

#include "lutlib/bake/bake.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <utility>

namespace lutlib {
namespace {

Transform transform_of(const TestLook& look) {
    return Transform::each([f = look.f](RgbD c) { return saturate(f(c)); });
}

LatticeReader cube_reader(int size, Interpolation how) {
    Lut lut;
    lut.cube = identity_cube(size);
    return reader_of(lut, how);
}

LatticeFit fit_of(const Transform& look, const LatticeReader& reader) {
    return LatticeFit(look, reader, point_samples(look, reader));
}

class FitOfEngine : public testing::TestWithParam<Engine> {};
INSTANTIATE_TEST_SUITE_P(Engines, FitOfEngine,
                         testing::ValuesIn(engines().begin(), engines().end()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(FitOfEngine, reader_is_the_lookup_of_the_engine) {
    const Engine& engine = GetParam();
    const int size = engine.default_size;
    const LatticeReader reader = reader_of(engine, size);
    Lut3D cube = identity_cube(size);
    for (std::size_t k = 0; k < cube.nodes.size(); ++k) {
        const auto noise = [&](double by) {
            return static_cast<float>(std::abs(std::sin(static_cast<double>(k) * by)));
        };
        cube.nodes[k] = {noise(12.9), noise(78.2), noise(37.7)};
    }
    const Picture picture = to_picture(cube, *layout_named(engine.layout));
    // In units of nodes, as places are.
    const auto last = static_cast<float>(size - 1);
    cube.domain = {{0, 0, 0}, {last, last, last}};
    for (int i = 0; i < 2000; ++i) {
        const RgbD in{std::fmod(i * 0.8191, 1.0), std::fmod(i * 0.6710, 1.0),
                      std::fmod(i * 0.5497, 1.0)};
        const RgbD place{reader.place(in.r, 0), reader.place(in.g, 1), reader.place(in.b, 2)};
        const NodeWeights w = node_weights(reader.how, size, place);
        RgbD sum;
        for (std::size_t k = 0; k < w.count; ++k) {
            sum = sum + w.weight[k] * to_double(cube.nodes[w.node[k]]);
        }
        EXPECT_LT(largest_magnitude(sum - evaluate_exact(cube, place, reader.how)), 1e-14);
        if (engine.filtering == Filtering::light) {
            continue; // the reader weighs codes, which comes near it
        }
        const Rgb got = engine.lookup(picture, size, to_float(in));
        for (std::size_t c = 0; c < 3; ++c) {
            // Texture coordinates in float over pictures up to 4096 wide: 2^-24 * 4096 of a node.
            EXPECT_NEAR(sum[c], got[c], 5e-4);
        }
    }
}

TEST_P(FitOfEngine, point_samples_are_where_the_engine_reads_its_nodes) {
    const Engine& engine = GetParam();
    const int size = engine.default_size;
    const std::vector<RgbD> nodes = point_samples({}, reader_of(engine, size));
    const auto n = static_cast<std::size_t>(size);
    for (int i = 0; i < size; ++i) {
        // Bisection stops at 2^-50.
        EXPECT_NEAR(nodes[static_cast<std::size_t>(i)].r, engine.node_input(i, size), 1e-12);
        EXPECT_NEAR(nodes[n * n * static_cast<std::size_t>(i)].b, engine.node_input(i, size),
                    1e-12);
    }
}

class FitOfLook : public testing::TestWithParam<TestLook> {};
INSTANTIATE_TEST_SUITE_P(Looks, FitOfLook, testing::ValuesIn(test_looks()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(FitOfLook, is_never_worse_than_point_samples) {
    for (const Interpolation how :
         {Interpolation::nearest, Interpolation::trilinear, Interpolation::tetrahedral}) {
        const Transform look = transform_of(GetParam());
        const LatticeReader reader = cube_reader(9, how);
        const LatticeFit fit = fit_of(look, reader);
        for (const FittedLattice& result : {fit.exact(), fit.rounded({8}), fit.rounded({10})}) {
            EXPECT_LE(result.result.max, result.point_sampled.max) << name_of(how);
            EXPECT_LE(result.result.mean, result.point_sampled.mean) << name_of(how);
            if (!result.fitted) {
                EXPECT_EQ(result.result.mean, result.point_sampled.mean);
            }
        }
    }
}

TEST_P(FitOfLook, gives_codes_within_range_and_keeps_the_corners) {
    const Transform look = transform_of(GetParam());
    const LatticeReader reader = cube_reader(9, Interpolation::tetrahedral);
    const std::vector<RgbD> point = point_samples(look, reader);
    const FittedLattice result = LatticeFit(look, reader, point).rounded({8});
    for (const RgbD& node : result.nodes) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_GE(node[c], 0);
            EXPECT_LE(node[c], 1);
            EXPECT_NEAR(node[c] * 255, std::round(node[c] * 255), 1e-9);
        }
    }
    for (const std::size_t corner : {std::size_t{0}, std::size_t{8}, result.nodes.size() - 1}) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_EQ(result.nodes[corner][c], std::floor(point[corner][c] * 255 + 0.5) / 255);
        }
    }
}

TEST(Fit, lowers_the_mean_error_of_curved_looks_by_a_third) {
    const Transform look =
        transform_of({"contrast", [](RgbD c) {
                          const auto s = [](double x) { return x * x * (3 - 2 * x); };
                          return RgbD{s(c.r), s(0.5 * (c.g + c.r)), s(c.b)};
                      }});
    for (const Interpolation how : {Interpolation::trilinear, Interpolation::tetrahedral}) {
        const LatticeFit fit = fit_of(look, cube_reader(9, how));
        const FittedLattice exact = fit.exact(), codes = fit.rounded({8});
        EXPECT_TRUE(exact.fitted && codes.fitted);
        EXPECT_LT(exact.result.mean, 0.67 * exact.point_sampled.mean);
        EXPECT_LT(codes.result.mean, 0.8 * codes.point_sampled.mean);
    }
}

TEST(Fit, keeps_point_samples_where_they_are_exact) {
    const Transform identity;
    const FittedLattice result = fit_of(identity, cube_reader(9, Interpolation::trilinear)).exact();
    EXPECT_FALSE(result.fitted);
    EXPECT_LT(result.result.max, 1e-7); // inputs are floats
}

TEST(Fit, reads_wide_domains_and_shapers) {
    Lut lut;
    lut.shaper = Lut1D{{{0, 0, 0}, {4, 4, 4}}, {}};
    for (int i = 0; i < 256; ++i) {
        const auto y = static_cast<float>(std::log2(1 + 7 * i / 255.0) / 3);
        lut.shaper->entries.push_back({y, y, y});
    }
    lut.cube = identity_cube(9);
    const Transform look = Transform::each([](RgbD c) {
        return RgbD{std::sqrt(c.r / 4 + 0.1), std::sqrt(c.g / 4 + 0.1), c.b / (c.b + 1)};
    });
    const FittedLattice result = fit_of(look, reader_of(lut, Interpolation::tetrahedral)).exact();
    EXPECT_TRUE(result.fitted);
    EXPECT_LT(result.result.mean, 0.8 * result.point_sampled.mean);
}

TEST(Fit, survives_looks_that_are_not_finite_or_not_of_this_world) {
    const Transform rude = Transform::each([](RgbD c) {
        return RgbD{c.r > 0.5 ? std::nan("") : c.r, 1e30 * c.g, c.b > 0.3 ? 1 : -1e-320};
    });
    const LatticeReader reader = cube_reader(5, Interpolation::tetrahedral);
    const LatticeFit fit = fit_of(rude, reader);
    for (const FittedLattice& result : {fit.exact(), fit.rounded({8})}) {
        for (const RgbD& node : result.nodes) {
            EXPECT_TRUE(std::isfinite(node.r) && std::isfinite(node.g) && std::isfinite(node.b));
        }
    }
}

TEST(Fit, gives_the_same_nodes_whatever_the_number_of_threads) {
    const Transform look = transform_of(test_looks()[1]);
    const LatticeReader reader = cube_reader(9, Interpolation::trilinear);
    const auto nodes_with = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const LatticeFit fit = fit_of(look, reader);
        return std::pair(fit.exact().nodes, fit.rounded({8}).nodes);
    };
    const auto alone = nodes_with(1);
    for (const std::size_t threads : {2U, 3U, 8U}) {
        EXPECT_EQ(nodes_with(threads), alone) << threads;
    }
}

} // namespace
} // namespace lutlib
