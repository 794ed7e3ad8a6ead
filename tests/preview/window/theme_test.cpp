// The colours of the panels: neutral, and told apart by everybody.
#include "preview/panels/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace preview::panels {
namespace {

std::array<std::uint8_t, 3> color_of(int slot) {
    const auto greys = theme_greys();
    const auto row = std::find_if(greys.begin(), greys.end(),
                                  [&](const ThemeGrey& it) { return it.slot == slot; });
    if (row == greys.end()) {
        throw std::out_of_range("no grey");
    }
    EXPECT_EQ(row->opacity, 255) << name_of_slot(slot) << " is compared";
    return {row->code, row->code, row->code};
}

TEST(Theme, has_a_grey_for_every_colour_of_the_style) {
    std::set<int> slots;
    for (const ThemeGrey& row : theme_greys()) {
        EXPECT_TRUE(slots.insert(row.slot).second) << name_of_slot(row.slot);
    }
    for (int slot = 0; slot < slot_count(); ++slot) {
        EXPECT_EQ(slots.count(slot), 1U) << name_of_slot(slot);
    }
}

TEST(Theme, contrast_is_that_of_wcag) {
    EXPECT_NEAR(contrast_of({0, 0, 0}, {255, 255, 255}), 21, 1e-9);
    EXPECT_EQ(contrast_of({9, 9, 9}, {9, 9, 9}), 1);
    // The grey that WebAIM's checker names as the lightest of AA on white.
    EXPECT_NEAR(contrast_of({118, 118, 118}, {255, 255, 255}), 4.54, 0.005);
    EXPECT_EQ(contrast_of({1, 2, 3}, {200, 100, 50}), contrast_of({200, 100, 50}, {1, 2, 3}));
}

TEST(Theme, holds_the_contrasts_of_wcag_aa) {
    for (const ThemePair& pair : theme_pairs()) {
        EXPECT_GE(contrast_of(color_of(pair.front), color_of(pair.back)), pair.least)
            << name_of_slot(pair.front) << " on " << name_of_slot(pair.back);
    }
    for (const int back : window_slots()) {
        EXPECT_GE(contrast_of(warning_color, color_of(back)), 4.5);
    }
}

TEST(Theme, is_as_dark_as_a_surround_should_be) {
    // ISO 3664:2009: at most a fifth of the white's luminance.
    const double over_white = contrast_of(color_of(window_slots()[0]), {255, 255, 255});
    EXPECT_GE(over_white, 1.05 / 0.25);
}

} // namespace
} // namespace preview::panels
