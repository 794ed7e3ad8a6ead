#include "lutlib/interpolation/apply.h"

#include "lutlib/codes.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <random>

namespace lutlib {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float denormal = std::numeric_limits<float>::denorm_min();
constexpr Domain odd_domain{{-1, 0, 0.25F}, {3, 0.7F, 2}};

struct Shape {
    int size;        // of the cube; 0: none
    int shaper_size; // 0: none
    Domain domain;

    friend void PrintTo(const Shape& s, std::ostream* out) {
        *out << s.size << " nodes, a 1D table of " << s.shaper_size
             << (s.domain.is_unit() ? "" : ", odd domain");
    }
};

Lut random_look(const Shape& shape) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> value(-0.2F, 1.2F);
    const auto color = [&] { return Rgb{value(random), value(random), value(random)}; };
    Lut lut;
    if (shape.size > 0) {
        lut.cube = identity_cube(shape.size, shape.shaper_size > 0 ? Domain{} : shape.domain);
        std::generate(lut.cube->nodes.begin(), lut.cube->nodes.end(), color);
    }
    if (shape.shaper_size > 0) {
        lut.shaper =
            Lut1D{shape.domain, std::vector<Rgb>(static_cast<std::size_t>(shape.shaper_size))};
        std::generate(lut.shaper->entries.begin(), lut.shaper->entries.end(), color);
    }
    return lut;
}

// Every special value in every channel beside others, then colours in and around the domain, nodes
// of the lattice and equal channels among them.
std::vector<Rgb> inputs_for(const Shape& shape) {
    const float specials[] = {nan,    inf,   -inf,  0,      -0.0F,    denormal, -denormal,
                              1e-38F, 1e30F, 3e38F, -3e38F, 1,        0.5F,     -1e-7F,
                              0.25F,  0.7F,  2,     3,      0.999999F};
    std::vector<Rgb> out;
    for (const float a : specials) {
        for (const float b : specials) {
            out.push_back({a, b, 0.3F});
            out.push_back({0.6F, a, b});
            out.push_back({b, 0.1F, a});
        }
    }
    std::mt19937 random(12);
    std::uniform_real_distribution<float> place(-0.1F, 1.1F);
    for (int i = 0; i < 3000; ++i) {
        Rgb c;
        for (std::size_t k = 0; k < 3; ++k) {
            const float t = i % 3 == 0 && shape.size > 0
                                ? std::round(place(random) * static_cast<float>(shape.size - 1)) /
                                      static_cast<float>(shape.size - 1)
                                : place(random);
            c[k] = std::lerp(shape.domain.min[k], shape.domain.max[k], t);
        }
        out.push_back(i % 7 == 0 ? Rgb{c.r, c.r, c.g} : c);
    }
    return out;
}

std::vector<float> packed(const std::vector<Rgb>& colors, std::size_t channels) {
    std::vector<float> out;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        out.insert(out.end(), {colors[i].r, colors[i].g, colors[i].b});
        if (channels == 4) {
            out.push_back(i % 5 == 0 ? nan : static_cast<float>(i));
        }
    }
    return out;
}

bool same(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

void expect_as_evaluated(const Lut& lut, const InterpolationInfo& how,
                         const std::vector<Rgb>& inputs) {
    const StoredLut stored(lut);
    const Lookup& lookup = lookup_of(how.kind);
    for (const std::size_t channels : {3U, 4U}) {
        const std::vector<float> in = packed(inputs, channels);
        std::vector<float> out(in.size(), -7);
        apply_on_this_thread(stored, lookup, in.data(), out.data(), inputs.size(), channels);
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const Rgb one = evaluate(lut, inputs[i], how.kind);
            for (std::size_t c = 0; c < 3; ++c) {
                // The same operations in the same order, each rounded for itself. Only the sign of
                // a zero may differ, where nodes of no weight differ.
                ASSERT_TRUE(same(out[channels * i + c], one[c]))
                    << how.name << " of " << inputs[i].r << " " << inputs[i].g << " " << inputs[i].b
                    << ", channel " << c << ": " << out[channels * i + c] << ", not " << one[c];
            }
            if (channels == 4) {
                ASSERT_TRUE(same(out[4 * i + 3], in[4 * i + 3]));
            }
        }
        std::vector<float> in_place = in;
        apply_on_this_thread(stored, lookup, in_place.data(), in_place.data(), inputs.size(),
                             channels);
        EXPECT_TRUE(std::equal(in_place.begin(), in_place.end(), out.begin(), same));
    }
}

// Every instruction set that this machine has and the library was built for.
class OnEveryProcessor : public testing::TestWithParam<Shape> {
  protected:
    void TearDown() override { hwy::SetSupportedTargetsForTest(0); }
};
INSTANTIATE_TEST_SUITE_P(Shapes, OnEveryProcessor,
                         testing::Values(Shape{2, 0, {}}, Shape{3, 0, odd_domain}, Shape{17, 0, {}},
                                         Shape{33, 0, odd_domain}, Shape{65, 0, {}},
                                         Shape{17, 2, {}}, Shape{2, 1024, odd_domain},
                                         Shape{33, 1024, {}}, Shape{0, 3, {}},
                                         Shape{0, 4096, odd_domain}, Shape{0, 0, {}}));

TEST_P(OnEveryProcessor, many_pixels_are_what_evaluate_makes_of_each) {
    const Lut lut = random_look(GetParam());
    const std::vector<Rgb> inputs = inputs_for(GetParam());
    for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
        hwy::SetSupportedTargetsForTest(left & -left);
        SCOPED_TRACE(hwy::TargetName(left & -left));
        for (const InterpolationInfo& how : interpolations()) {
            expect_as_evaluated(lut, how, inputs);
        }
    }
}

TEST(Apply, takes_any_number_of_pixels_and_writes_no_more) {
    const Shape shape{17, 64, {}};
    const Lut lut = random_look(shape);
    const StoredLut stored(lut);
    const std::vector<Rgb> inputs = inputs_for(shape);
    for (const std::size_t channels : {3U, 4U}) {
        for (std::size_t count = 0; count < 70; ++count) {
            const std::vector<float> in =
                packed({inputs.end() - static_cast<std::ptrdiff_t>(count), inputs.end()}, channels);
            std::vector<float> out(in.size() + 64, -7);
            apply_on_this_thread(stored, lookup_of(Interpolation::tetrahedral), in.data(),
                                 out.data(), count, channels);
            for (std::size_t i = 0; i < count; ++i) {
                const Rgb one =
                    evaluate(lut, {in[channels * i], in[channels * i + 1], in[channels * i + 2]});
                ASSERT_EQ(out[channels * i], one.r);
                ASSERT_EQ(out[channels * i + 2], one.b);
            }
            for (std::size_t i = in.size(); i < out.size(); ++i) {
                ASSERT_EQ(out[i], -7) << count;
            }
        }
    }
}

TEST(Apply, gives_finite_colors_for_every_input_of_the_largest_finite_nodes) {
    Lut lut;
    lut.cube = identity_cube(2);
    for (std::size_t i = 0; i < 8; ++i) {
        const float v = (i % 2 ? 1.0F : -1.0F) * std::numeric_limits<float>::max();
        lut.cube->nodes[i] = {v, -v, v};
    }
    const std::vector<Rgb> inputs = inputs_for({2, 0, {}});
    for (const InterpolationInfo& how : interpolations()) {
        expect_as_evaluated(lut, how, inputs);
    }
}

class EveryStorageOnEveryProcessor : public testing::TestWithParam<Storage> {
  protected:
    void TearDown() override { hwy::SetSupportedTargetsForTest(0); }
};
INSTANTIATE_TEST_SUITE_P(Storages, EveryStorageOnEveryProcessor,
                         testing::ValuesIn(storages().begin(), storages().end()),
                         [](const auto& row) { return "bits_" + std::string(row.param.name); });

TEST_P(EveryStorageOnEveryProcessor, reads_what_evaluate_reads_of_the_nodes_it_keeps) {
    const Storage& storage = GetParam();
    const CodeDepth depth{storage.bits};
    const Shape shape{17, 0, odd_domain};
    Lut lut = random_look(shape);
    std::vector<RgbD> nodes;
    for (Rgb& node : lut.cube->nodes) {
        nodes.push_back(to_double(node));
        for (std::size_t c = 0; c < 3; ++c) {
            const double v = node[c];
            if (storage.bits > 0) {
                node[c] = static_cast<float>(depth.value(depth.code(v)));
            } else if (storage.format == NodeFormat::halves) {
                const double step = std::ldexp(1, std::max(std::ilogb(v == 0 ? 1 : v), -14) - 10);
                node[c] = static_cast<float>(std::nearbyint(v / step) * step);
            }
        }
    }
    const StoredLut stored(lut, nodes, storage);
    const std::vector<Rgb> inputs = inputs_for(shape);
    std::vector<Rgb> out(inputs.size());
    for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
        hwy::SetSupportedTargetsForTest(left & -left);
        SCOPED_TRACE(hwy::TargetName(left & -left));
        for (const InterpolationInfo& how : interpolations()) {
            stored.apply(inputs, out, lookup_of(how.kind));
            for (std::size_t i = 0; i < inputs.size(); ++i) {
                const Rgb one = evaluate(lut, inputs[i], how.kind);
                for (std::size_t c = 0; c < 3; ++c) {
                    // Codes are weighed before they are divided: some roundings of values up to 1.
                    ASSERT_NEAR(out[i][c], one[c], storage.bits > 0 ? 5e-7F : 0);
                }
            }
        }
    }
}

TEST(PixelsOutside, counts_each_pixel_once_and_nan_among_them) {
    std::vector<Rgb> inputs = inputs_for({0, 0, odd_domain});
    for (const Domain& domain : {Domain{}, odd_domain}) {
        for (const std::size_t channels : {3U, 4U}) {
            for (const std::size_t count : {std::size_t{0}, std::size_t{5}, inputs.size()}) {
                std::size_t expected = 0;
                for (std::size_t i = 0; i < count; ++i) {
                    bool inside = true;
                    for (std::size_t c = 0; c < 3; ++c) {
                        inside = inside && inputs[i][c] >= domain.min[c] &&
                                 inputs[i][c] <= domain.max[c];
                    }
                    expected += !inside;
                }
                const std::vector<float> in = packed(inputs, channels);
                EXPECT_EQ(pixels_outside(domain, in.data(), count, channels), expected);
            }
        }
    }
}

} // namespace
} // namespace lutlib
