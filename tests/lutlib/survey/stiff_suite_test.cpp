#include "lutlib/interpolation/interpolation.h"
#include "lutlib/resample/resample.h"
#include "lutlib/survey/stiff_suite.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace lutlib {
namespace {

class EveryStiffLook : public testing::TestWithParam<StiffLook> {};
INSTANTIATE_TEST_SUITE_P(Suite, EveryStiffLook,
                         testing::ValuesIn(stiff_suite().begin(), stiff_suite().end()),
                         [](const auto& row) { return std::string(row.param.name); });

// The steepest edge along each axis, walked by brute force: over the lattice's own nodes, or over
// the 1D table's entries where there is one.
double steepest_edge(const Lut& lut) {
    const int lines = lut.cube ? lut.cube->size : 1;
    const int steps = lut.shaper ? lut.shaper->size() : lut.cube->size;
    const auto value = [&](std::size_t axis, int i, int u, int v) {
        RgbD at;
        const double across[] = {i / (steps - 1.0), u / std::max(1.0, lines - 1.0),
                                 v / std::max(1.0, lines - 1.0)};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t c = (axis + k) % 3;
            at[c] = std::lerp(static_cast<double>(lut.domain().min[c]),
                              static_cast<double>(lut.domain().max[c]), across[k]);
        }
        return evaluate_exact(lut, at);
    };
    double most = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int u = 0; u < lines; ++u) {
            for (int v = 0; v < lines; ++v) {
                RgbD last = value(axis, 0, u, v);
                for (int i = 1; i < steps; ++i) {
                    const RgbD next = value(axis, i, u, v);
                    most = std::max(most, largest_magnitude(next - last) * (steps - 1));
                    last = next;
                }
            }
        }
    }
    return most;
}

TEST_P(EveryStiffLook, is_valid_and_the_same_each_time) {
    const Lut lut = GetParam().make();
    EXPECT_NO_THROW(validate(lut));
    EXPECT_TRUE(lut.shaper || lut.cube);
    const Lut again = GetParam().make();
    EXPECT_TRUE(lut.shaper == again.shaper && lut.cube == again.cube);
}

TEST_P(EveryStiffLook, has_the_stiffness_that_the_table_says) {
    // The table's numbers are rounded to three digits or more.
    const double stated = GetParam().stiffness;
    EXPECT_NEAR(steepest_edge(GetParam().make()), stated, 5e-3 * stated);
}

TEST_P(EveryStiffLook, gives_finite_colors_for_every_input_with_every_interpolation) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const Lut lut = GetParam().make();
    const Domain& d = lut.domain();
    const float inputs[] = {nan,     inf,     -inf,  0,      -0.0F, 1e-45F, 1e-38F,
                            -1e30F,  1e30F,   0.25F, 0.499F, 0.5F,  0.501F, 1,
                            d.min.r, d.max.r, 2e5F,  3e-7F,  3e38F, -3e38F, 0.5000005F};
    for (const ResamplingMethod& method : resampling_methods()) {
        const Transform read = method.transform_of(lut);
        for (std::size_t i = 0; lut.cube && i < std::size(inputs); ++i) {
            for (const float b : inputs) {
                const RgbD out = read({inputs[i], inputs[(i * 5) % std::size(inputs)], b});
                ASSERT_TRUE(std::isfinite(out.r) && std::isfinite(out.g) && std::isfinite(out.b))
                    << method.name << " of " << inputs[i] << " " << b;
            }
        }
    }
    for (const InterpolationInfo& how : interpolations()) {
        for (const float r : inputs) {
            for (const float g : inputs) {
                for (const float b : inputs) {
                    const Rgb fast = evaluate(lut, {r, g, b}, how.kind);
                    const RgbD exact = evaluate_exact(lut, {r, g, b}, how.kind);
                    for (std::size_t c = 0; c < 3; ++c) {
                        ASSERT_TRUE(std::isfinite(fast[c]) && std::isfinite(exact[c]))
                            << how.name << " of " << r << " " << g << " " << b;
                    }
                }
            }
        }
    }
}

TEST(StiffSuite, names_its_looks_once) {
    std::set<std::string_view> names;
    for (const StiffLook& look : stiff_suite()) {
        EXPECT_TRUE(names.insert(look.name).second) << look.name;
        EXPECT_EQ(stiff_look_named(look.name), &look);
    }
    EXPECT_EQ(stiff_look_named("none"), nullptr);
}

} // namespace
} // namespace lutlib
