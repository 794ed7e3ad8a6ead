#include "lutlib/plot/scatter.h"
#include "tests/lutlib/plot/markup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plot {
namespace {

constexpr const char* circle_x =
    "<circle cx=\"([0-9.]+)\" cy=\"[0-9.]+\" r=\"[0-9.]+\" class=\"mark";
constexpr const char* circle_y =
    "<circle cx=\"[0-9.]+\" cy=\"([0-9.]+)\" r=\"[0-9.]+\" class=\"mark";

Scatter scatter_of(const std::vector<std::pair<double, double>>& places) {
    Scatter out;
    out.title = "Error against time";
    out.x_label = "ns";
    out.y_label = "dE2000";
    out.series = {{"trilinear"}};
    for (const auto& [x, y] : places) {
        Mark mark;
        mark.x = x;
        mark.y = y;
        mark.label = "mark";
        mark.row = out.marks.size();
        out.marks.push_back(mark);
    }
    return out;
}

TEST(Scatter, equal_factors_are_equal_steps_right_and_up) {
    const std::string text = svg(scatter_of({{1, 0.01}, {10, 0.1}, {100, 1}}));
    const std::vector<double> x = numbers_of(text, circle_x);
    const std::vector<double> y = numbers_of(text, circle_y);
    ASSERT_EQ(x.size(), 3U);
    EXPECT_GT(x[1] - x[0], 100);
    EXPECT_NEAR(x[2] - x[1], x[1] - x[0], 0.11); // written to a tenth of a pixel
    EXPECT_LT(y[1] - y[0], -50);
    EXPECT_NEAR(y[2] - y[1], y[1] - y[0], 0.11);
}

TEST(Scatter, what_no_logarithmic_axis_can_show_stands_at_the_edge_and_says_so) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const std::string text =
        svg(scatter_of({{1, 1}, {10, 10}, {0, 1}, {1, infinity}, {-3, 5}, {1, nan}}));
    EXPECT_EQ(all_of(text, "<title>mark( \\(beyond the axis\\))</title>").size(), 4U);
    EXPECT_EQ(all_of(text, "<title>(mark)</title>").size(), 2U);
    const std::vector<double> x = numbers_of(text, circle_x);
    const std::vector<double> y = numbers_of(text, circle_y);
    ASSERT_EQ(x.size(), 6U);
    EXPECT_EQ(x[2], x[4]);
    EXPECT_LT(x[2], x[0]);
    EXPECT_EQ(y[3], y[5]);
    EXPECT_LT(y[3], y[1]);
    for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_TRUE(x[i] >= 0 && x[i] <= 860 && y[i] >= 0 && y[i] <= 500) << i;
    }
}

TEST(Scatter, few_decades_are_labelled_between_and_far_powers_are_written_as_such) {
    const std::string few = svg(scatter_of({{1, 1}, {10, 10}}));
    for (const char* label : {">1<", ">2<", ">5<", ">10<"}) {
        EXPECT_NE(few.find(label), std::string::npos) << label;
    }
    const std::string many = svg(scatter_of({{1e-7, 1}, {1e7, 1}}));
    EXPECT_EQ(many.find(">2<"), std::string::npos);
    EXPECT_NE(many.find("10<tspan dy=\"-6\" font-size=\"11\">-6</tspan>"), std::string::npos)
        << many;
}

TEST(Scatter, the_front_is_a_staircase_from_left_to_right) {
    Scatter scatter = scatter_of({{100, 1}, {1, 100}, {10, 10}, {50, 50}});
    for (const std::size_t mark : {0U, 1U, 2U}) {
        scatter.marks[mark].on_front = true;
    }
    const std::vector<std::string> paths =
        all_of(svg(scatter), "<path class=\"front\" d=\"([^\"]+)\"");
    ASSERT_EQ(paths.size(), 1U);
    const std::vector<double> across = numbers_of(paths[0], "[MH]([0-9.]+)");
    ASSERT_EQ(across.size(), 3U);
    EXPECT_TRUE(std::is_sorted(across.begin(), across.end()));
    const std::vector<double> down = numbers_of(paths[0], "[ V]([0-9.]+)");
    ASSERT_EQ(down.size(), 3U);
    EXPECT_TRUE(std::is_sorted(down.begin(), down.end())); // better is lower
    EXPECT_EQ(svg(scatter_of({{1, 1}})).find("class=\"front\""), std::string::npos);
}

TEST(Scatter, pale_marks_lie_below_and_every_mark_leads_to_its_row) {
    Scatter scatter = scatter_of({{1, 1}, {2, 2}, {3, 3}});
    scatter.marks[1].pale = true;
    scatter.marks[2].diamond = true;
    scatter.marks[2].recommended = true;
    const std::string text = svg(scatter);
    EXPECT_EQ(all_of(text, "data-row=\"([0-9]+)\""), (std::vector<std::string>{"1", "0", "2"}));
    EXPECT_EQ(all_of(text, "class=\"(mark[a-z ]*) s0\""),
              (std::vector<std::string>{"mark", "mark top", "mark best"}));
    EXPECT_EQ(all_of(text, "<path (d)=\"M[0-9. ]+l").size(), 1U);
}

TEST(Scatter, no_mark_hides_another) {
    Scatter scatter = scatter_of({{1, 1}, {10, 10}});
    for (int i = 0; i < 12; ++i) {
        scatter.marks.push_back(scatter.marks[1]);
        scatter.marks.back().pale = true;
    }
    const std::string text = svg(scatter);
    const std::vector<double> x = numbers_of(text, circle_x), y = numbers_of(text, circle_y);
    ASSERT_EQ(x.size(), 14U);
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_GT(std::hypot(x[i] - x[k], y[i] - y[k]), 4) << i << " " << k;
        }
    }
}

TEST(Scatter, names_the_knees_of_the_front_and_shows_intervals_that_are_wide_enough) {
    Scatter scatter = scatter_of({{1, 100}, {10, 10}, {10.01, 9.99}, {100, 1}, {50, 50}});
    for (Mark& mark : scatter.marks) {
        mark.on_front = mark.x != 50;
        mark.name = "at " + std::to_string(static_cast<int>(mark.x * 100));
    }
    scatter.marks[1].x_low = 7;
    scatter.marks[1].x_high = 14;
    scatter.marks[3].x_low = 99.9;
    scatter.marks[3].x_high = 100.1;
    const std::string text = svg(scatter);
    // Of two in one place one is named; what is not on the front is not.
    const auto names = all_of(text, "class=\"name\"[^>]*>(at [0-9]+)<");
    EXPECT_EQ(names.size(), 3U) << text;
    EXPECT_EQ(std::count(names.begin(), names.end(), "at 5000"), 0);
    EXPECT_EQ(all_of(text, "class=\"(interval)\"").size(), 1U);
}

TEST(Scatter, series_have_colors_of_their_own) {
    Scatter scatter = scatter_of({{5, 1}, {6, 1}, {1, 1}, {10, 10}});
    scatter.series = {{"nearest"}, {"trilinear"}};
    scatter.marks[1].series = 1;
    const std::string text = svg(scatter);
    const auto fills = all_of(text, "class=\"mark[a-z ]* (s[0-9])\"");
    EXPECT_EQ(std::count(fills.begin(), fills.end(), "s1"), 1);
    EXPECT_EQ(fills.size(), 4U);
    for (const char* name : {">nearest<", ">trilinear<"}) {
        EXPECT_NE(text.find(name), std::string::npos) << name;
    }
}

TEST(Scatter, the_floor_keeps_small_values_from_stretching_the_axis) {
    Scatter scatter = scatter_of({{1, 1e-9}, {1, 1}, {1, 10}});
    const std::vector<double> stretched = numbers_of(svg(scatter), circle_y);
    scatter.y_floor = 0.1;
    const std::string text = svg(scatter);
    const std::vector<double> held = numbers_of(text, circle_y);
    EXPECT_GT(held[1] - held[2], 3 * (stretched[1] - stretched[2]));
    EXPECT_EQ(all_of(text, "(beyond the axis)").size(), 1U);
}

TEST(Scatter, text_is_escaped_wherever_it_stands) {
    Scatter scatter = scatter_of({{1, 1}});
    const std::string rude = "<b>\"A\" & B</b>";
    scatter.title = scatter.x_label = scatter.y_label = scatter.circle_name = scatter.diamond_name =
        scatter.series[0].name = scatter.marks[0].label = rude;
    const std::string text = svg(scatter);
    EXPECT_EQ(text.find(rude), std::string::npos);
    EXPECT_EQ(all_of(text, "(&lt;b&gt;&quot;A&quot; &amp; B&lt;/b&gt;)").size(), 8U);
    EXPECT_EQ(unbalanced_element(text), "");
}

TEST(Scatter, without_marks_it_still_has_axes) {
    const std::string text = svg(scatter_of({}));
    EXPECT_NE(text.find("class=\"frame\""), std::string::npos);
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_EQ(unbalanced_element(text), "");
}

} // namespace
} // namespace plot
