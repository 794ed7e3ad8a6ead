#include "lutlib/plot/heat_map.h"
#include "lutlib/plot/lines.h"
#include "lutlib/plot/palette.h"
#include "tests/lutlib/plot/markup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace plot {
namespace {

TEST(HeatMap, letters_rise_with_errors_by_equal_factors) {
    const std::string letters = level_letters();
    ASSERT_EQ(letters.size(), heat_levels);
    EXPECT_EQ(std::set<char>(letters.begin(), letters.end()).size(), heat_levels);
    EXPECT_EQ(error_letter(0), letters.front());
    EXPECT_EQ(error_letter(heat_low), letters.front());
    EXPECT_EQ(error_letter(heat_high), letters.back());
    EXPECT_EQ(error_letter(INFINITY), letters.back());
    EXPECT_EQ(error_letter(std::nan("")), no_level);
    const double middle = std::sqrt(heat_low * heat_high);
    EXPECT_NEAR(static_cast<double>(letters.find(error_letter(middle))), 31.5, 0.6);
    EXPECT_EQ(share_letter(-1), letters.front());
    EXPECT_EQ(share_letter(2), letters.back());
}

TEST(HeatMap, lightness_of_its_colors_rises) {
    double last = -1;
    for (std::size_t level = 0; level < heat_levels; ++level) {
        const std::string color = heat_color(level);
        const auto channel = [&](std::size_t at) {
            return std::stoi(color.substr(at, 2), nullptr, 16);
        };
        const double luma = 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
        EXPECT_GT(luma, last) << level;
        last = luma;
    }
}

TEST(HeatMap, draws_a_cell_for_every_letter_from_the_bottom_up) {
    const HeatMap map{.id = "m",
                      .title = "a < b",
                      .x_label = "x",
                      .y_label = "y",
                      .columns = 2,
                      .rows = 2,
                      .levels = "0_.0",
                      .lines_every = 1};
    const std::string text = svg(map);
    EXPECT_EQ(unbalanced_element(text), "");
    const auto fills = all_of(text, "<path fill=\"([^\"]+)\"");
    EXPECT_EQ(fills,
              (std::vector<std::string>{heat_color(0), heat_color(63), "none", heat_color(0)}));
    const auto y = numbers_of(text, "<path fill=\"[^\"]+\" d=\"M[0-9.]+ ([0-9.]+)");
    EXPECT_GT(y[0], y[2]);
    EXPECT_NE(text.find("a &lt; b"), std::string::npos);
    EXPECT_EQ(all_of(text, "class=\"(node)\"").size(), 1U);
}

TEST(Band, has_a_color_for_every_three_letters) {
    const std::string text = svg(Band{"b", "band", "000___0_0"});
    EXPECT_EQ(all_of(text, "<path fill=\"([^\"]+)\""),
              (std::vector<std::string>{"#000000", "#ffffff", "#00ff00"}));
    EXPECT_EQ(unbalanced_element(text), "");
}

TEST(Lines, slopes_on_logarithmic_axes_are_straight_and_what_has_no_place_is_left_out) {
    Lines plot;
    plot.title = "order";
    plot.lines = {{"two", "", 0, false, true, {{0.01, 1e-4}, {0.1, 1e-2}, {1, 1}, {0.5, 0}}},
                  {"flat", "", 1, true, false, {{0.01, 1}, {1, 1}}}};
    const std::string text = svg(plot);
    EXPECT_EQ(unbalanced_element(text), "");
    const auto x = numbers_of(text, "<circle cx=\"([0-9.]+)\"");
    const auto y = numbers_of(text, "<circle cx=\"[0-9.]+\" cy=\"([0-9.]+)\"");
    ASSERT_EQ(x.size(), 3U);
    EXPECT_NEAR((y[1] - y[0]) / (x[1] - x[0]), (y[2] - y[1]) / (x[2] - x[1]), 2e-3);
    EXPECT_EQ(all_of(text, "class=\"line( dashed)\"").size(), 2U); // itself and in the legend
    EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(Lines, of_shares_run_from_the_bottom_to_the_top) {
    Lines plot;
    plot.y_is_share = true;
    plot.x_low = 1;
    plot.x_high = 100;
    plot.first_line_id = "it";
    plot.lines = {{"", "", 0, false, false, {{1, 0}, {100, 1}}}};
    const std::string path = share_path(plot, {{1, 0}, {100, 1}});
    const auto y = numbers_of(path, " ([0-9.]+)");
    ASSERT_EQ(y.size(), 2U);
    EXPECT_GT(y[0], y[1]);
    EXPECT_NE(svg(plot).find("id=\"it\""), std::string::npos);
}

} // namespace
} // namespace plot
