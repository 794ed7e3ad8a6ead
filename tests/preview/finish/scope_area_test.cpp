// Which texels the scopes count of a side.
#include "preview/finish/scope_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace preview {
namespace {

const ScopeSide &side_a = scope_sides[1], &side_b = scope_sides[2];

bool has(const ScopeArea& area, std::uint32_t x, std::uint32_t y) {
    return x >= area.x && x < area.x + area.width && y >= area.y && y < area.y + area.height &&
           is_counted(area, x, y);
}

TEST(ScopeArea, of_all_that_is_shown_is_the_output_but_of_a_heat_map) {
    for (const Compare& compare : compares) {
        const ScopeArea area = scope_area(scope_side_shown, compare, {}, {}, {200, 90});
        const bool is_heat = &compare == &compare_difference;
        EXPECT_EQ(area.columns(), is_heat ? 0U : 200U) << compare.name;
        EXPECT_EQ(area.is_empty(), is_heat) << compare.name;
        EXPECT_EQ(no_scope_because(area, scope_side_shown, compare, {}).empty(), !is_heat);
    }
}

TEST(ScopeArea, of_a_side_is_the_picture_or_its_half_where_no_border_divides_it) {
    for (const Compare& compare : compares) {
        if (compare.shows_one || &compare == &compare_difference) {
            continue;
        }
        SCOPED_TRACE(compare.name);
        const bool is_pair = &compare == &compare_side;
        for (const ScopeSide* side : {&side_a, &side_b}) {
            const bool is_a = side == &side_a, is_shown = is_a ? compare.shows_a : compare.shows_b;
            const ScopeArea area = scope_area(*side, compare, {}, {}, {200, 90});
            EXPECT_EQ(area, !is_shown ? ScopeArea{}
                                      : (ScopeArea{.x = is_pair && !is_a ? 100U : 0U,
                                                   .width = is_pair ? 100U : 200U,
                                                   .height = 90}));
            EXPECT_EQ(no_scope_because(area, *side, compare, {}),
                      is_shown ? "" : "its side is not shown");
        }
    }
}

// The line is four texels wide at 2160 lines; antialiasing takes one more each side.
TEST(ScopeArea, of_an_upright_or_level_line_is_a_rectangle_beside_it) {
    const auto beside = [](const ScopeSide& side, float angle) {
        return scope_area(side, compare_split, {.split_angle = angle}, {}, {200, 2160});
    };
    EXPECT_EQ(beside(side_a, 0), (ScopeArea{.width = 97, .height = 2160}));
    EXPECT_EQ(beside(side_b, 0), (ScopeArea{.x = 103, .width = 97, .height = 2160}));
    EXPECT_EQ(beside(side_b, 180), (ScopeArea{.width = 97, .height = 2160}));
    EXPECT_EQ(beside(side_a, 90), (ScopeArea{.width = 200, .height = 1077}));
    EXPECT_EQ(beside(side_b, 90), (ScopeArea{.y = 1083, .width = 200, .height = 1077}));
    const Wipe middle{.box_x = 0.25F, .box_y = 0.25F, .box_width = 0.5F, .box_height = 0.5F};
    EXPECT_EQ(scope_area(side_a, compare_box, middle, {}, {1000, 540}),
              (ScopeArea{.x = 252, .y = 137, .width = 496, .height = 266}));
}

// As the picture is made: texel by texel, apart from those near the border.
TEST(ScopeArea, has_every_texel_that_shows_the_side_away_from_the_border_and_no_other) {
    constexpr Size size{61, 37};
    for (const Compare* compare : {&compare_split, &compare_box}) {
        for (int step = 0; step < 48; ++step) {
            const Wipe wipe{.split = static_cast<float>(step % 7) / 6,
                            .split_angle = static_cast<float>(step) * 7.5F,
                            .box_x = static_cast<float>(step % 5) / 6,
                            .box_y = static_cast<float>(step % 3) / 4,
                            .box_width = static_cast<float>(step % 6) / 6,
                            .box_height = static_cast<float>(step % 8) / 6};
            const WipeShape shape = wipe_shape(wipe, *compare, size);
            const ScopeArea a = scope_area(side_a, *compare, wipe, {}, size);
            const ScopeArea b = scope_area(side_b, *compare, wipe, {}, size);
            SCOPED_TRACE(std::string(compare->name) + " " + std::to_string(step));
            int counted = 0;
            for (std::uint32_t y = 0; y < size.height; ++y) {
                for (std::uint32_t x = 0; x < size.width; ++x) {
                    const double cx = x + 0.5, cy = y + 0.5;
                    const bool is_a = shows_a(shape, *compare, cx, cy);
                    const auto at = [&](std::size_t i) { return static_cast<double>(shape[i]); };
                    const double away = compare == &compare_box
                                            ? std::abs(std::max(std::max(at(0) - cx, cx - at(2)),
                                                                std::max(at(1) - cy, cy - at(3))))
                                            : std::abs(cx * at(0) + cy * at(1) - at(2));
                    if (std::abs(away - 1.5) < 1e-4) {
                        continue; // either, by rounding
                    }
                    const bool is_away = away > 1.5;
                    ASSERT_EQ(has(a, x, y), is_away && is_a) << x << " " << y;
                    ASSERT_EQ(has(b, x, y), is_away && !is_a) << x << " " << y;
                    counted += is_away ? 1 : 0;
                }
            }
            EXPECT_EQ(counted == 0, a.is_empty() && b.is_empty());
        }
    }
}

TEST(ScopeArea, says_that_the_border_leaves_nothing) {
    const Wipe wipe{.split = 0};
    const ScopeArea none = scope_area(side_a, compare_split, wipe, {}, {200, 90});
    EXPECT_TRUE(none.is_empty());
    EXPECT_EQ(no_scope_because(none, side_a, compare_split, {}),
              "the comparison's border leaves nothing of its side");
    const Wipe all{.box_x = 0, .box_y = 0, .box_width = 1, .box_height = 1};
    EXPECT_TRUE(scope_area(side_b, compare_box, all, {}, {200, 90}).is_empty());
    EXPECT_FALSE(scope_area(side_a, compare_box, all, {}, {200, 90}).is_empty());
}

TEST(ScopeArea, of_a_region_is_its_whole_texels_of_the_side) {
    const ScopeRegion region{0.1F, 0.2F, 0.3F, 0.4F};
    const ScopeArea whole{.x = 20, .y = 18, .width = 60, .height = 36};
    EXPECT_EQ(scope_area(scope_side_shown, compare_split, {}, region, {200, 90}), whole);
    EXPECT_EQ(scope_area(side_a, compare_split, {}, region, {200, 90}), whole);
    ScopeArea pair = whole;
    pair.copies = 2;
    pair.stride = 200;
    EXPECT_EQ(scope_area(scope_side_shown, compare_side, {}, region, {400, 90}), pair);
    ScopeArea right = whole;
    right.x += 200;
    EXPECT_EQ(scope_area(side_b, compare_side, {}, region, {400, 90}), right);
    const ScopeArea other = scope_area(side_b, compare_split, {}, region, {200, 90});
    EXPECT_TRUE(other.is_empty());
    EXPECT_EQ(no_scope_because(other, side_b, compare_split, region),
              "nothing of its side is in the region");
    // The line stands at 100; at 540 lines it and its blending take 1.5 texels either way.
    EXPECT_EQ(scope_area(side_b, compare_split, {}, {0.25F, 0.5F, 0.5F, 0.5F}, {200, 90}),
              (ScopeArea{.x = 102, .y = 45, .width = 48, .height = 45}));
}

TEST(ScopeArea, of_a_region_has_a_texel_however_small_it_is_and_none_beyond_the_picture) {
    for (const float at : {0.0F, 0.3F, 1.0F}) {
        for (const float length : {0.0F, 0.001F, 5.0F}) {
            const ScopeArea area = texels_of({at, at, length, length}, {7, 1});
            EXPECT_GE(area.width, 1U);
            EXPECT_EQ(area.height, 1U);
            EXPECT_LE(area.x + area.width, 7U);
        }
    }
}

// As --scope-region says them.
TEST(ScopeArea, of_texels_as_shares_is_those_texels) {
    for (const std::uint32_t length : {1U, 3U, 641U, 16384U}) {
        for (std::uint32_t begin = 0; begin < length; begin += 1 + length / 50) {
            for (std::uint32_t end = begin + 1; end <= length; end += 1 + length / 50) {
                const auto share = [&](std::uint32_t texels) {
                    return static_cast<float>(texels) / static_cast<float>(length);
                };
                const ScopeArea area =
                    texels_of({share(begin), 0, share(end - begin), 1}, {length, 2});
                ASSERT_EQ(area.x, begin) << length;
                ASSERT_EQ(area.width, end - begin) << length;
            }
        }
    }
}

} // namespace
} // namespace preview
