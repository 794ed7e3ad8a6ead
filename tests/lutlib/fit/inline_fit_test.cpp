// Looks as small as code can hold them.
#include "lutlib/color/encoding.h"
#include "lutlib/fit/curves_fit.h"
#include "lutlib/fit/inline_fit.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/metrics/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lutlib {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

RgbD warm(RgbD c) {
    return {std::pow(std::abs(c.r), 0.8), 0.9 * c.g + 0.05 * c.b * c.r, 0.2 + 0.5 * c.b * c.b};
}

// Light through a matrix, between the curve of sRGB and its inverse.
RgbD mixed_in_light(RgbD c) {
    const RgbD light{srgb().decode(c.r), srgb().decode(c.g), srgb().decode(c.b)};
    return {srgb().encode(0.7 * light.r + 0.2 * light.g + 0.1 * light.b),
            srgb().encode(0.1 * light.r + 0.8 * light.g + 0.1 * light.b),
            srgb().encode(0.05 * light.r + 0.15 * light.g + 0.8 * light.b)};
}

std::vector<Rgb> colors_of(const Domain& domain) {
    return over_domain(sample_colors(5, {.neutral = 65, .random = 2000}), domain);
}

TEST(InlineLattice, is_the_lattice_of_its_unpacked_nodes) {
    const Domain domain{{-0.5F, 0, 0}, {2, 1, 1.5F}};
    const InlineLattice packed = inline_lattice(Transform::each(warm), domain, 5);
    Lut lut;
    lut.cube = identity_cube(5, domain);
    double worst = 0;
    for (std::size_t i = 0; i < packed.nodes.size(); ++i) {
        const RgbD node = warm(to_double(lut.cube->nodes[i]));
        for (std::size_t c = 0; c < 3; ++c) {
            const auto code = packed.nodes[i] >> (10 * c) & 1023U;
            const double value = packed.low[c] + double{packed.step[c]} * code;
            worst = std::max(worst, std::abs(value - node[c]) / packed.step[c]);
            lut.cube->nodes[i][c] = static_cast<float>(value);
        }
    }
    EXPECT_LT(worst, 0.501); // of a code
    const Transform twin = transform_of(packed);
    for (const Rgb& color : colors_of(domain)) {
        const RgbD d = twin(to_double(color)) -
                       evaluate_exact(lut, to_double(color), Interpolation::tetrahedral);
        EXPECT_LT(largest_magnitude(d), 1e-6);
    }
    const RgbD broken = twin({not_a_number, -9, INFINITY});
    EXPECT_LT(largest_magnitude(broken - twin({-0.5, 0, 1.5})), 1e-12);
}

TEST(InlineLattice, of_a_constant_look_is_that_constant) {
    const InlineLattice packed = inline_lattice(Transform::each([](RgbD) {
                                                    return RgbD{0.25, 0.5, 3};
                                                }),
                                                {}, 2);
    EXPECT_EQ(packed.step, (Rgb{0, 0, 0}));
    EXPECT_EQ(transform_of(packed)(RgbD{0.3, 0.9, 0.1}), (RgbD{0.25, 0.5, 3}));
}

TEST(FitCurves, finds_a_matrix_between_the_curves_of_light) {
    const Transform look = Transform::each(mixed_in_light);
    const std::vector<InlineCurves> found = fit_curves(look, {}, {}, 33);
    ASSERT_FALSE(found.empty());
    const Difference d = compare(look, transform_of(found.front()), colors_of({}), Viewing());
    EXPECT_LT(d.delta_e_2000.max, 1);
    EXPECT_LT(d.delta_e_2000.mean, 0.1);
    // The matrix itself, but for what the curves behind it may take of each row.
    for (std::size_t row = 0; row < 3; ++row) {
        const Rgb m = found.front().matrix[row];
        const float sum = m.r + m.g + m.b;
        const Rgb expected = row == 0   ? Rgb{0.7F, 0.2F, 0.1F}
                             : row == 1 ? Rgb{0.1F, 0.8F, 0.1F}
                                        : Rgb{0.05F, 0.15F, 0.8F};
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(m[k] / sum, expected[k], 0.02) << row << k;
        }
    }
}

TEST(FitCurves, stands_looks_that_are_not_of_its_form) {
    for (const auto& look : {Transform::each([](RgbD) {
                                 return RgbD{0.5, 0.5, 0.5};
                             }),
                             Transform::each([](RgbD c) {
                                 return c.r > 0.5 ? RgbD{1, 0, 0} : RgbD{0, 0, c.g * c.b};
                             }),
                             Transform::each([](RgbD) {
                                 return RgbD{not_a_number, INFINITY, 0};
                             })}) {
        for (const InlineCurves& curves : fit_curves(look, {}, {}, 9)) {
            const RgbD image = transform_of(curves)(RgbD{0.3, 0.6, 0.9});
            EXPECT_TRUE(std::isfinite(largest_magnitude(image)));
        }
    }
}

TEST(FitInline, takes_curves_where_the_channels_do_not_mix_and_lattices_where_they_do) {
    const Transform apart = Transform::each([](RgbD c) {
        return RgbD{c.r * c.r, 1 - c.g, 0.5 * c.b};
    });
    EXPECT_TRUE(keeps_channels_apart(apart, {}));
    const InlineSearch curves = fit_inline(apart, {}, no_breaks(), {}, Viewing(), 0.5);
    ASSERT_TRUE(curves.found);
    EXPECT_FALSE(std::get<InlineCurves>(curves.found->look).mixes);
    EXPECT_LE(curves.found->error.delta_e_2000.max, 0.5);

    const Transform mixing = Transform::each(warm);
    EXPECT_FALSE(keeps_channels_apart(mixing, {}));
    const InlineSearch coarse = fit_inline(mixing, {}, no_breaks(), {}, Viewing(), 8);
    const InlineSearch fine = fit_inline(mixing, {}, no_breaks(), {}, Viewing(), 3);
    ASSERT_TRUE(coarse.found && fine.found);
    EXPECT_LT(numbers_of(coarse.found->look), numbers_of(fine.found->look));
    const InlineSearch light =
        fit_inline(Transform::each(mixed_in_light), {}, no_breaks(), {}, Viewing(), 1);
    ASSERT_TRUE(light.found);
    EXPECT_TRUE(std::get<InlineCurves>(light.found->look).mixes);
}

TEST(FitInline, names_the_closest_where_none_is_close_enough_and_its_error_would_do) {
    const Transform stiff = Transform::each([](RgbD c) {
        const double s = c.r + c.g * c.b > 0.613 ? 1 : 0.2;
        return RgbD{s * c.r, s * c.g, s * c.b};
    });
    const InlineSearch none = fit_inline(stiff, {}, no_breaks(), {}, Viewing(), 1);
    EXPECT_FALSE(none.found);
    const double least = none.closest.error.delta_e_2000.max;
    EXPECT_GT(least, 1);
    const InlineSearch some = fit_inline(stiff, {}, no_breaks(), {}, Viewing(), least);
    ASSERT_TRUE(some.found);
    EXPECT_LE(some.found->error.delta_e_2000.max, least);
}

TEST(FitInline, of_a_table_with_a_shaper_keeps_the_shaper) {
    // Steep near 0, as a logarithm is, over a domain that no lattice of evenly spaced nodes suits.
    Lut table;
    table.shaper = Lut1D{{{0, 0, 0}, {16, 16, 16}}, {}};
    for (int i = 0; i < 65; ++i) {
        const auto value = static_cast<float>(std::log2(1 + 4 * i) / 8.2);
        table.shaper->entries.push_back({value, value, value});
    }
    table.cube = identity_cube(5);
    for (Rgb& node : table.cube->nodes) {
        node = to_float(warm(to_double(node)));
    }
    const Transform look = Transform::of(table);
    const ShapedTable shaped{table, Interpolation::tetrahedral};
    const InlineSearch with =
        fit_inline(look, table.domain(), no_breaks(), {}, Viewing(), 1, shaped);
    ASSERT_TRUE(with.found);
    ASSERT_TRUE(std::holds_alternative<InlineShaped>(with.found->look));
    EXPECT_LE(numbers_of(with.found->look), 3U * 65 + 125);
    // All that is lost are ten bits a node.
    EXPECT_LT(with.found->error.absolute.max, 1.0 / 1023);
    EXPECT_FALSE(fit_inline(look, table.domain(), no_breaks(), {}, Viewing(), 1).found);
    const Transform form = transform_of(with.found->look);
    EXPECT_EQ(form({not_a_number, 99, -1}), form({0, 16, 0}));
}

} // namespace
} // namespace lutlib
