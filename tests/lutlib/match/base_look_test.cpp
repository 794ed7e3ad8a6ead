#include "lutlib/error.h"
#include "lutlib/match/base_look.h"
#include "tests/lutlib/looks.h"
#include "tests/lutlib/match/pairs.h"

#include <gtest/gtest.h>

namespace lutlib {
namespace {

std::vector<ColorPair> exact_pairs(RgbD (*look)(RgbD)) {
    std::vector<ColorPair> out;
    for (const PixelPair& pixel : picture_pairs([](RgbD c) { return c; }, 3000)) {
        out.push_back({to_double(pixel.before), look(to_double(pixel.before)), 1});
    }
    return out;
}

double mean_off(const BaseLook& base, RgbD (*look)(RgbD), double from, double to) {
    double sum = 0;
    int count = 0;
    for (int b = 0; b <= 8; ++b) {
        for (int g = 0; g <= 8; ++g) {
            for (int r = 0; r <= 8; ++r) {
                const auto at = [&](int i) { return from + (to - from) * i / 8; };
                const RgbD in{at(r), at(g), at(b)};
                sum += largest_magnitude(base(in) - look(in));
                ++count;
            }
        }
    }
    return sum / count;
}

// Of muted colours it learns what saturated ones become.
TEST(BaseLook, extends_what_curves_a_matrix_and_chroma_do_to_colours_that_nobody_showed) {
    const auto warm = [](RgbD c) {
        const double y = test_luma(c);
        const auto s = [](double x) { return x + 0.15 * x * (1 - x); };
        return RgbD{s(y + 0.8 * (c.r - y)), s(y + 0.8 * (c.g - y)), 0.9 * (y + 0.8 * (c.b - y))};
    };
    const BaseLook base = fitted_base(exact_pairs(warm));
    EXPECT_LT(mean_off(base, warm, 0, 1), 2.0 / 255);
    const BaseLook none = fitted_base(exact_pairs([](RgbD c) { return c; }));
    EXPECT_LT(mean_off(
                  none, [](RgbD c) { return c; }, 0, 1),
              1e-3);
}

TEST(BaseLook, rises_along_the_greys_whatever_the_pairs_say_and_falls_for_a_negative) {
    std::vector<ColorPair> pairs = exact_pairs([](RgbD c) { return c; });
    for (ColorPair& pair : pairs) {
        const double wave = 0.2 * std::sin(30 * pair.before.g);
        pair.after = pair.after + RgbD{wave, wave, wave};
    }
    const BaseLook base = fitted_base(pairs);
    const BaseLook negative = fitted_base(exact_pairs([](RgbD c) {
        return RgbD{1 - c.r, 1 - c.g, 1 - c.b};
    }));
    for (int i = 0; i < 200; ++i) {
        const double x = i / 200.0, next = (i + 1) / 200.0;
        const RgbD rise = base({next, next, next}) - base({x, x, x});
        const RgbD fall = negative({next, next, next}) - negative({x, x, x});
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_GE(rise[c], -1e-12);
            EXPECT_LE(fall[c], 1e-12);
        }
        EXPECT_LT(largest_magnitude(negative({x, x, x}) - RgbD{1 - x, 1 - x, 1 - x}), 0.01);
    }
}

TEST(BaseLook, goes_on_where_the_codes_of_a_channel_end) {
    const auto bright = [](RgbD c) { return RgbD{1.8 * c.r, 1.8 * c.g, 1.8 * c.b}; };
    std::vector<ColorPair> pairs = exact_pairs(bright);
    for (ColorPair& pair : pairs) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (pair.after[c] >= 1) {
                pair.after[c] = 1;
                pair.clipped[c] = 1;
            }
        }
    }
    const BaseLook base = fitted_base(pairs);
    for (double x = 0.1; x < 0.55; x += 0.01) {
        EXPECT_LT(largest_magnitude(base({x, x, x}) - bright({x, x, x})), 1.0 / 255) << x;
    }
    EXPECT_GT(base({0.8, 0.8, 0.8}).g, 1.2);
}

TEST(BaseLook, has_no_kink) {
    const BaseLook base = fitted_base(exact_pairs(test_looks()[2].f));
    const auto at = [&](double x) { return base({0.7 * x, x, 0.4 + 0.2 * x}).g; };
    constexpr double h = 1e-4;
    double most = 0;
    for (double x = 0.01; x < 0.99; x += 1e-3) {
        const double before = (at(x) - at(x - h)) / h, after = (at(x + h) - at(x)) / h;
        most = std::max(most, std::abs(after - before));
    }
    // Slopes are about 0.5, and would jump by a tenth of that at a kink.
    EXPECT_LT(most, 0.01);
}

TEST(BaseLook, refuses_to_learn_from_nothing) {
    EXPECT_THROW(fitted_base({}), Error);
    const std::vector<ColorPair> weightless{{{0, 0, 0}, {0, 0, 0}, 0}};
    EXPECT_THROW(fitted_base(weightless), Error);
    const std::vector<ColorPair> one{{{0.5, 0.5, 0.5}, {0.4, 0.5, 0.6}, 1}};
    EXPECT_LT(largest_magnitude(fitted_base(one)({0.5, 0.5, 0.5}) - RgbD{0.4, 0.5, 0.6}), 0.02);
}

} // namespace
} // namespace lutlib
