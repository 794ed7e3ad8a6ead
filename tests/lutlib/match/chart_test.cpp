#include "lutlib/color/difference.h"
#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/match/chart.h"
#include "lutlib/match/match_patches.h"
#include "lutlib/paint/turn.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <limits>

namespace lutlib {
namespace {

constexpr ChartArea place{30, 20, 240, 160};

// Patches of 40x40 pixels with black borders, in a grey picture.
template <class F>
Picture photo(F look) {
    Picture out{320, 220, std::vector<Rgb>(320 * 220, to_float(look(RgbD{0.4, 0.4, 0.4})))};
    const auto patches = published_chart();
    for (int y = 0; y < place.height; ++y) {
        for (int x = 0; x < place.width; ++x) {
            const bool is_border = x % 40 < 4 || x % 40 >= 36 || y % 40 < 4 || y % 40 >= 36;
            const RgbD color = is_border ? RgbD{0.05, 0.05, 0.05}
                                         : patches[static_cast<std::size_t>(y / 40 * 6 + x / 40)];
            out.at(place.left + x, place.top + y) = to_float(look(color));
        }
    }
    return out;
}

const auto unchanged = [](RgbD c) { return c; };
const auto warm = [](RgbD c) {
    return RgbD{0.05 + 0.9 * c.r, 0.03 + 0.85 * c.g * (1.1 - 0.1 * c.g), 0.75 * c.b};
};

TEST(Chart, is_read_in_order_whichever_way_it_lies) {
    const auto published = published_chart();
    for (const Turn& turn : all_turns()) {
        const Picture upright = photo(unchanged), lying = turned(upright, turn);
        const Pixel a = after_turn({place.left, place.top}, upright.size(), turn),
                    b = after_turn({place.left + place.width - 1, place.top + place.height - 1},
                                   upright.size(), turn);
        const ChartArea area{std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x) + 1,
                             std::abs(a.y - b.y) + 1};
        const auto found = chart_in(lying, area);
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_LT(largest_magnitude(found[i] - published[i]), 1e-6)
                << words_of(turn) << ' ' << i;
        }
    }
}

TEST(Chart, is_known_under_looks_and_without_colours) {
    const auto published = published_chart();
    for (const TestLook& look : test_looks()) {
        const auto found = chart_in(photo(look.f), place);
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_LT(largest_magnitude(found[i] - look.f(published[i])), 1e-6) << look.name;
        }
    }
    const auto grey = [](RgbD c) {
        const double y = test_luma(c);
        return RgbD{y, y, y};
    };
    EXPECT_NO_THROW(chart_in(photo(grey), place));
}

TEST(Chart, refuses_what_is_none_and_what_is_not_within_the_picture) {
    const auto refused = [](const Picture& picture, const ChartArea& area, const char* says) {
        try {
            chart_in(picture, area);
            ADD_FAILURE() << says;
        } catch (const Error& error) {
            EXPECT_NE(error.message().find(says), std::string::npos) << error.message();
        }
    };
    const Picture picture = photo(unchanged);
    refused(picture, {200, 20, 240, 160}, "reaches beyond its 320x220 pixels");
    refused(picture, {-1, 20, 240, 160}, "reaches beyond");
    refused(picture, {30, 20, 23, 16}, "too small");
    refused(picture, {70, 20, 240, 160}, "no ColorChecker");
    refused(Picture{320, 220, std::vector<Rgb>(320 * 220, Rgb{0.5F, 0.5F, 0.5F})}, place,
            "no ColorChecker");
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    refused(Picture{320, 220, std::vector<Rgb>(320 * 220, Rgb{nan, nan, nan})}, place,
            "no pixel that is there");
}

// By which chart_in() tells the one way from the others.
TEST(Chart, published_does_not_follow_itself_turned) {
    const auto patches = published_chart();
    for (const Turn& turn : {Turn{2, false}, Turn{0, true}, Turn{2, true}}) {
        double x = 0, xx = 0, xy = 0;
        for (int i = 0; i < 24; ++i) {
            const Pixel at = before_turn({i % 6, i / 6}, {6, 4}, turn);
            const double is = test_luma(patches[static_cast<std::size_t>(i)]),
                         other = test_luma(patches[static_cast<std::size_t>(at.y * 6 + at.x)]);
            x += is;
            xx += is * is;
            xy += is * other;
        }
        const double correlation = (xy - x * x / 24) / (xx - x * x / 24);
        EXPECT_LT(correlation * correlation, 0.37) << words_of(turn);
    }
}

TEST(MatchPatches, learns_a_look_from_24_colours_and_says_how_well) {
    std::vector<ColorPair> patches;
    for (const RgbD& patch : published_chart()) {
        patches.push_back({patch, warm(patch), 1});
    }
    const Match match = match_patches(patches, 17);
    double most = 0, sum = 0;
    for (int b = 1; b < 8; ++b) {
        for (int g = 1; g < 8; ++g) {
            for (int r = 1; r < 8; ++r) {
                const RgbD in{0.1 + r * 0.1, 0.1 + g * 0.1, 0.1 + b * 0.1};
                const RgbD out = evaluate_exact(match.cube, in, Interpolation::tetrahedral);
                const double off = delta_e_2000(saturate(out), saturate(warm(in)));
                most = std::max(most, off);
                sum += off / 343;
            }
        }
    }
    EXPECT_LT(sum, 1);
    EXPECT_LT(most, 5);
    const std::vector<RgbD> left_out = each_from_the_others(patches);
    double mean = 0;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const RgbD at = evaluate_exact(match.cube, patches[i].before, Interpolation::tetrahedral);
        EXPECT_LT(delta_e_2000(at, patches[i].after), 0.5) << i;
        mean += delta_e_2000(left_out[i], patches[i].after) / chart_patches;
    }
    EXPECT_LT(mean, 1.5);
    EXPECT_GT(mean, 0.01);
}

} // namespace
} // namespace lutlib
