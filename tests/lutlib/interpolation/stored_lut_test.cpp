#include "lutlib/interpolation/stored_lut.h"

#include "lutlib/codes.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lutlib {
namespace {

Lut saturated_lut(int size, const Domain& domain = {}) {
    Lut lut;
    lut.cube = sampled(test_looks()[1].f, size);
    lut.cube->domain = domain;
    return lut;
}

std::vector<RgbD> nodes_of(const Lut& lut) {
    std::vector<RgbD> out;
    for (const Rgb& node : lut.cube->nodes) {
        out.push_back(to_double(node));
    }
    return out;
}

std::vector<Rgb> inputs_around(const Domain& domain) {
    std::vector<Rgb> out;
    for (int i = 0; i < 3000; ++i) {
        Rgb c;
        const Rgb t{std::fmod(static_cast<float>(i) * 0.8191F, 1.2F) - 0.1F,
                    std::fmod(static_cast<float>(i) * 0.6710F, 1.2F) - 0.1F,
                    std::fmod(static_cast<float>(i) * 0.5497F, 1.2F) - 0.1F};
        for (std::size_t k = 0; k < 3; ++k) {
            c[k] = domain.min[k] + t[k] * (domain.max[k] - domain.min[k]);
        }
        out.push_back(c);
    }
    return out;
}

// The double oracle of a lookup that holds the fractions between nodes in so many bits.
RgbD read_exactly(const Lut3D& cube, Rgb in, const Lookup& lookup) {
    if (lookup.fraction_bits == 0) {
        return evaluate_exact(cube, to_double(in), lookup.weights);
    }
    const auto steps = static_cast<float>(1 << lookup.fraction_bits);
    const auto last = static_cast<float>(cube.size - 1);
    RgbD place;
    for (std::size_t c = 0; c < 3; ++c) {
        // In float, so that both round to the same step.
        const float t = (in[c] - cube.domain.min[c]) / (cube.domain.max[c] - cube.domain.min[c]);
        const float x = saturate(t) * last;
        const float node = std::min(std::floor(x), last - 1);
        place[c] = static_cast<double>(node + std::floor((x - node) * steps + 0.5F) / steps);
    }
    Lut3D in_nodes = cube;
    in_nodes.domain = {{0, 0, 0}, {last, last, last}};
    return evaluate_exact(in_nodes, place, lookup.weights);
}

class EveryStorage : public testing::TestWithParam<Storage> {};
INSTANTIATE_TEST_SUITE_P(Storages, EveryStorage,
                         testing::ValuesIn(storages().begin(), storages().end()),
                         [](const auto& row) { return "bits_" + std::string(row.param.name); });

TEST_P(EveryStorage, reads_what_the_double_oracle_reads_within_its_rounding) {
    const Storage& storage = GetParam();
    // Half a code; of halves below 1, 2^-12; and float arithmetic.
    const double rounding = storage.bits > 0 ? 0.5 / CodeDepth{storage.bits}.maximum()
                            : storage.format == NodeFormat::halves ? 0x1p-12
                                                                   : 0;
    for (const Domain& domain : {Domain{}, Domain{{-1, 0, 0.25F}, {3, 0.5F, 2}}}) {
        const Lut lut = saturated_lut(9, domain);
        const StoredLut stored(lut, nodes_of(lut), storage);
        EXPECT_EQ(stored.bytes(), 729 * storage.bytes);
        const std::vector<Rgb> in = inputs_around(domain);
        std::vector<Rgb> out(in.size());
        for (const Lookup& lookup : lookups()) {
            if (lookup.weights == Interpolation::nearest) {
                continue; // compared at nodes below; halfway between them rounding decides
            }
            stored.apply(in, out, lookup);
            for (std::size_t i = 0; i < in.size(); ++i) {
                const RgbD exact = read_exactly(*lut.cube, in[i], lookup);
                for (std::size_t c = 0; c < 3; ++c) {
                    ASSERT_NEAR(static_cast<double>(out[i][c]), exact[c], rounding + 5e-6)
                        << lookup.name;
                }
            }
        }
    }
}

TEST_P(EveryStorage, reads_nodes_exactly_in_every_lookup) {
    const Storage& storage = GetParam();
    Lut lut;
    lut.cube = identity_cube(5);
    for (Rgb& node : lut.cube->nodes) {
        node = node.r > 0.4F ? Rgb{1, 0, 1} : Rgb{0, 1, 0}; // codes of every storage
    }
    const StoredLut stored(lut, nodes_of(lut), storage);
    const std::vector<Rgb> in = identity_cube(5).nodes;
    std::vector<Rgb> out(in.size());
    for (const Lookup& lookup : lookups()) {
        stored.apply(in, out, lookup);
        for (std::size_t i = 0; i < in.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                // The code times its reciprocal.
                EXPECT_NEAR(out[i][c], lut.cube->nodes[i][c], 1e-6F) << lookup.name;
            }
        }
    }
}

TEST_P(EveryStorage, answers_every_input_and_every_node_with_a_number) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    Lut lut;
    lut.cube = identity_cube(2);
    std::vector<RgbD> nodes = nodes_of(lut);
    // Floats keep what they are given; the others make a number of it.
    const bool floats = GetParam().format == NodeFormat::floats;
    nodes[3] = {1e30, -1e30, floats ? 0.5 : std::nan("")};
    const StoredLut stored(lut, nodes, GetParam());
    const std::vector<Rgb> in{{std::nanf(""), 0.5F, inf}, {-inf, 1e30F, 0.3F}, {0.9F, 0.9F, 0.1F}};
    std::vector<Rgb> out(in.size());
    for (const Lookup& lookup : lookups()) {
        stored.apply(in, out, lookup);
        for (const Rgb& c : out) {
            EXPECT_TRUE(std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b));
        }
    }
}

TEST(StoredLut, rounds_halves_to_nearest_over_their_whole_range) {
    const Storage& half = storages()[3];
    ASSERT_EQ(half.format, NodeFormat::halves);
    Lut lut;
    lut.cube = identity_cube(2);
    for (const double value : {1.0, 0.1, 6e-8, 5.9e-5, 6.1e-5, 0.99999, 2047.9, 65503.0, -0.3}) {
        const StoredLut stored(lut, std::vector<RgbD>(8, {value, value, value}), half);
        const std::vector<Rgb> in{{0, 0, 0}};
        std::vector<Rgb> out(1);
        stored.apply(in, out, lookups()[0]);
        // Half a unit in the last of 11 bits, or of the subnormals' step.
        const double bound = std::max(std::abs(value) * 0x1p-11, 0x1p-25);
        EXPECT_NEAR(static_cast<double>(out[0].r), value, bound);
    }
}

TEST(StoredLut, goes_through_its_shaper) {
    Lut lut = saturated_lut(9);
    lut.shaper = Lut1D{{{0, 0, 0}, {4, 4, 4}}, {{0, 0, 0}, {0.7F, 0.6F, 0.5F}, {1, 1, 1}}};
    const StoredLut stored(lut, nodes_of(lut), storages().back());
    const std::vector<Rgb> in = inputs_around(lut.domain());
    std::vector<Rgb> out(in.size());
    stored.apply(in, out, lookups()[2]);
    for (std::size_t i = 0; i < in.size(); ++i) {
        const RgbD exact = evaluate_exact(lut, to_double(in[i]));
        EXPECT_NEAR(static_cast<double>(out[i].g), exact.g, 5e-6);
    }
}

} // namespace
} // namespace lutlib
