#include "lutlib/engine/engine.h"

#include "lutlib/bake/bake.h"
#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/recipe/placement.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lutlib {
namespace {

class EveryEngine : public testing::TestWithParam<Engine> {
  protected:
    const Engine& engine = GetParam();
    const Layout& layout = *layout_named(engine.layout);
    int size = engine.default_size;

    // The look's nodes in full precision, where this engine reads them.
    Picture picture_of(RgbD (*f)(RgbD)) const {
        Lut3D cube = identity_cube(size);
        for (int b = 0; b < size; ++b) {
            for (int g = 0; g < size; ++g) {
                for (int r = 0; r < size; ++r) {
                    cube.at(r, g, b) =
                        to_float(f({engine.node_input(r, size), engine.node_input(g, size),
                                    engine.node_input(b, size)}));
                }
            }
        }
        return to_picture(cube, layout);
    }
};
INSTANTIATE_TEST_SUITE_P(Engines, EveryEngine,
                         testing::ValuesIn(engines().begin(), engines().end()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(EveryEngine, has_a_contract_that_its_own_defaults_meet) {
    EXPECT_NO_THROW(check_contract(engine, engine.default_size, engine.default_bits));
    EXPECT_THROW(check_contract(engine, engine.default_size, 10), UsageError);
    EXPECT_FALSE(engine.label.empty() || engine.input.empty() || engine.import.empty() ||
                 engine.lookup_help.empty() || engine.source.empty());
}

TEST_P(EveryEngine, reads_each_node_exactly_at_the_input_it_states) {
    const Picture picture = picture_of([](RgbD c) { return RgbD{c.g, c.b, c.r}; });
    for (int i = 0; i < size; ++i) {
        const int j = (i * 7) % size, k = (i * 5) % size;
        const Rgb in = to_float(
            {engine.node_input(i, size), engine.node_input(j, size), engine.node_input(k, size)});
        const Rgb out = engine.lookup(picture, size, in);
        // A texture coordinate near 1 in float is off by 2^-25; times the picture's width that is
        // a share of 512 * 2^-25 of a node's step of 1/size at the most.
        EXPECT_NEAR(out.r, in.g, 4e-6);
        EXPECT_NEAR(out.g, in.b, 4e-6);
        EXPECT_NEAR(out.b, in.r, 4e-6);
    }
}

TEST_P(EveryEngine, keeps_black_and_white_of_the_identity_exactly) {
    const Picture picture = picture_of([](RgbD c) { return c; });
    for (const float v : {0.0F, 1.0F}) {
        const Rgb out = engine.lookup(picture, size, {v, v, v});
        EXPECT_NEAR(out.r, v, 4e-6);
        EXPECT_NEAR(out.g, v, 4e-6);
        EXPECT_NEAR(out.b, v, 4e-6);
    }
}

TEST_P(EveryEngine, leaves_the_identity_unchanged_between_nodes) {
    const Picture picture = picture_of([](RgbD c) { return c; });
    // Godot's clamped end texels cost up to half a node at both ends, and nothing elsewhere.
    const bool raw_coordinate = engine.node_input(1, size) * (size - 1) > 1.001;
    const double margin = raw_coordinate ? 1.5 / size : 0;
    // Light between two codes lies above the code between them, most beside black.
    const double off = engine.filtering == Filtering::light ? 0.005 : 4e-6;
    for (int i = 0; i <= 500; ++i) {
        const float v = static_cast<float>(margin + (1 - 2 * margin) * i / 500.0);
        const float w = static_cast<float>(margin + (1 - 2 * margin) * ((i * 37) % 501) / 500.0);
        const Rgb out = engine.lookup(picture, size, {v, w, 1 - v});
        EXPECT_NEAR(out.r, v, off);
        EXPECT_NEAR(out.g, w, off);
        EXPECT_NEAR(out.b, 1 - v, off);
    }
}

TEST_P(EveryEngine, gives_a_finite_answer_for_every_input) {
    const Picture picture = picture_of([](RgbD c) { return c; });
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const Rgb black = engine.lookup(picture, size, {0, 0, 0});
    EXPECT_EQ(engine.lookup(picture, size, {nan, -inf, -1e30F}), black);
    const Rgb white = engine.lookup(picture, size, {1, 1, 1});
    EXPECT_EQ(engine.lookup(picture, size, {inf, 2, 1e30F}), white);
}

TEST_P(EveryEngine, agrees_with_the_lattice_interpolated_in_double) {
    const auto look = test_looks()[1];
    const Picture picture = picture_of(look.f);
    Lut3D cube = from_picture(picture, layout, size);
    const bool in_light = engine.filtering == Filtering::light;
    for (Rgb& node : cube.nodes) {
        node = in_light ? to_float(conversion({srgb(), *encoding_named("linear")})(to_double(node)))
                        : node;
    }
    const Transform encode =
        in_light ? conversion({*encoding_named("linear"), srgb()}) : Transform{};
    for (int i = 0; i < 4000; ++i) {
        const Rgb in{static_cast<float>((i * 37) % 1001) / 1000,
                     static_cast<float>((i * 61) % 997) / 996,
                     static_cast<float>((i * 89) % 983) / 982};
        const Rgb out = engine.lookup(picture, size, in);
        RgbD position;
        for (std::size_t c = 0; c < 3; ++c) {
            position[c] = engine.place(static_cast<double>(in[c]), size) / (size - 1);
        }
        const RgbD exact = encode(evaluate_exact(cube, position, engine.interpolation));
        // The look's steepest slope is below 3 and a coordinate is off by 4e-6 (above).
        EXPECT_NEAR(out.r, exact.r, 1.2e-5);
        EXPECT_NEAR(out.g, exact.g, 1.2e-5);
        EXPECT_NEAR(out.b, exact.b, 1.2e-5);
    }
}

} // namespace
} // namespace lutlib
