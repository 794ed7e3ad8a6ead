// What panels compute, against what looks are known to do.
#include "converter/panels/hull.h"
#include "converter/panels/panel.h"
#include "converter/panels/parts.h"
#include "converter/panels/sweeps.h"
#include "lutlib/color/encoding.h"
#include "lutlib/color/ucs.h"
#include "lutlib/named.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <regex>

namespace converter_test {
namespace {

using converter::PlanePoint;
using converter::ShownLook;
using lutlib::RgbD;

ShownLook look_of(const std::function<RgbD(RgbD)>& f, const std::string& name = "it") {
    return {name, lutlib::Transform::each(f), {}, lutlib::srgb(), lutlib::srgb()};
}

RgbD same(RgbD c) {
    return c;
}
RgbD squared(RgbD c) {
    return {c.r * c.r, c.g * c.g, c.b * c.b};
}
RgbD grey(RgbD c) {
    const double y = (c.r + c.g + c.b) / 3;
    return {y, y, y};
}

std::vector<plot::Figure> figures(const char* panel, const std::vector<ShownLook>& looks) {
    return lutlib::require_named(converter::panels(), "panel", panel).figures(looks);
}

const plot::Line& line_named(const plot::Figure& figure, const std::string& name) {
    const auto line =
        std::find_if(figure.lines.begin(), figure.lines.end(), [&](const plot::Line& row) {
            return (row.label.empty() ? row.name : row.label).starts_with(name);
        });
    EXPECT_NE(line, figure.lines.end()) << name;
    return line == figure.lines.end() ? figure.lines.front() : *line;
}

TEST(Curves, are_the_looks_results_and_slopes_their_differences) {
    const std::vector<ShownLook> looks{look_of([](RgbD c) {
        return RgbD{c.r * c.r, c.g / 2, c.r};
    })};
    const auto curves = figures("curves", looks), slopes = figures("slopes", looks);
    ASSERT_EQ(curves.size(), 2U);
    for (const auto& [x, y] : line_named(curves[0], "red").points) {
        EXPECT_NEAR(y, x * x, 1e-12);
    }
    for (const auto& [x, y] : line_named(curves[0], "blue").points) {
        EXPECT_NEAR(y, x, 1e-12);
    }
    // Of blue alone red stays at its lowest.
    for (const auto& [x, y] : line_named(curves[1], "blue").points) {
        EXPECT_EQ(y, 0);
    }
    // A difference over an interval is a square's slope in its middle.
    for (const auto& [x, y] : line_named(slopes[0], "red").points) {
        EXPECT_NEAR(y, 2 * x, 1e-9);
    }
    for (const auto& [x, y] : line_named(slopes[1], "green").points) {
        EXPECT_NEAR(y, 0.5, 1e-9);
    }
}

TEST(Curves, span_the_domain_and_two_looks_the_same_axes) {
    ShownLook wide = look_of(same, "wide");
    wide.domain = {{-1, -1, -1}, {4, 4, 4}};
    const std::vector<ShownLook> looks{look_of(squared, "narrow"), wide};
    const plot::Figure figure = figures("curves", looks).front();
    EXPECT_EQ(line_named(figure, "narrow, red").points.front().first, 0);
    EXPECT_EQ(line_named(figure, "wide, red").points.front().first, -1);
    EXPECT_EQ(line_named(figure, "wide, red").points.back().first, 4);
    EXPECT_FALSE(line_named(figure, "narrow, red").dashed);
    EXPECT_TRUE(line_named(figure, "wide, red").dashed);
    EXPECT_NE(line_named(figure, "wide, red").pale, line_named(figure, "narrow, red").pale);
}

TEST(HueAndSaturation, of_the_identity_are_as_before) {
    const std::vector<ShownLook> looks{look_of(same)};
    for (const char* panel : {"hue", "saturation"}) {
        const plot::Figure figure = figures(panel, looks).front();
        ASSERT_EQ(figure.lines.size(), 12U);
        for (std::size_t i = 0; i < 6; ++i) {
            const auto &before = figure.lines[i].points, &after = figure.lines[i + 6].points;
            ASSERT_GT(before.size(), 70U) << panel;
            ASSERT_EQ(before.size(), after.size());
            for (std::size_t k = 0; k < before.size(); ++k) {
                EXPECT_EQ(before[k].first, after[k].first);
                // Nearly black codes keep fewer digits.
                EXPECT_NEAR(before[k].second, after[k].second, 1e-3) << panel << i;
            }
        }
    }
}

TEST(Saturation, is_13_times_the_distance_in_ucs_whatever_the_luminance) {
    const std::vector<converter::Sweep> sweeps = converter::sweeps_of(look_of(same));
    const plot::Figure figure = figures("saturation", {look_of(same)}).front();
    // Red, half way from grey in light: of BT.709, (1, 0.5, 0.5).
    const double X = 0.412391 + 0.5 * (0.357584 + 0.180481);
    const double Y = 0.212639 + 0.5 * (0.715169 + 0.072192);
    const double Z = 0.019331 + 0.5 * (0.119195 + 0.950532);
    const double u = 4 * X / (X + 15 * Y + 3 * Z), v = 9 * Y / (X + 15 * Y + 3 * Z);
    const double expected = 13 * std::hypot(u - 0.197830, v - 0.468320);
    for (const auto& [stop, s] : figure.lines.front().points) {
        if (std::isfinite(s)) {
            EXPECT_NEAR(s, expected, 2e-4) << stop;
        }
    }
    // 18 % grey is no stop from itself.
    const auto zero = std::find(sweeps[0].stops.begin(), sweeps[0].stops.end(), 0.0);
    ASSERT_NE(zero, sweeps[0].stops.end());
    const RgbD light = sweeps[0].before[static_cast<std::size_t>(zero - sweeps[0].stops.begin())];
    EXPECT_NEAR(converter::xyz_of_light(light).g, 0.18, 1e-9);
}

TEST(Hue, of_what_is_grey_there_is_none_and_a_swap_of_channels_turns_it) {
    const plot::Figure none = figures("hue", {look_of(grey)}).front();
    for (const auto& [x, hue] : none.lines[6].points) {
        EXPECT_TRUE(std::isnan(hue));
    }
    const plot::Figure drab = figures("saturation", {look_of(grey)}).front();
    for (const auto& [x, s] : drab.lines[6].points) {
        EXPECT_TRUE(std::isnan(s) || s < 1e-3) << s;
    }
    const plot::Figure turned = figures("hue", {look_of([](RgbD c) {
                                            return RgbD{c.b, c.r, c.g};
                                        })})
                                    .front();
    // Red has become green, 120 degrees on; half way from grey by light it is nearly so.
    const auto& red = turned.lines[6].points;
    EXPECT_NEAR(red[red.size() / 2].second - turned.lines[0].points[red.size() / 2].second, 120,
                12);
}

// An edge of the outline has every point on its left: for every two points the question anew.
std::vector<PlanePoint> slow_hull(const std::vector<PlanePoint>& points) {
    std::vector<PlanePoint> corners;
    for (const PlanePoint& a : points) {
        bool is_corner = false;
        for (const PlanePoint& b : points) {
            bool is_edge = a != b;
            for (const PlanePoint& c : points) {
                const double cross = (b.first - a.first) * (c.second - a.second) -
                                     (b.second - a.second) * (c.first - a.first);
                const double along = (c.first - a.first) * (b.first - a.first) +
                                     (c.second - a.second) * (b.second - a.second);
                const bool is_beyond =
                    cross == 0 &&
                    (along < 0 || std::hypot(c.first - a.first, c.second - a.second) >
                                      std::hypot(b.first - a.first, b.second - a.second));
                is_edge = is_edge && cross >= 0 && !is_beyond;
            }
            is_corner = is_corner || is_edge;
        }
        if (is_corner) {
            corners.push_back(a);
        }
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

TEST(ConvexHull, has_the_corners_that_a_question_for_every_two_points_finds) {
    std::vector<PlanePoint> points;
    unsigned seed = 1;
    for (int i = 0; i < 60; ++i) { // whole numbers, so that many lie in line or twice
        seed = seed * 1664525U + 1013904223U;
        points.emplace_back((seed >> 10U) % 12, (seed >> 20U) % 12);
    }
    std::vector<PlanePoint> hull = converter::convex_hull(points);
    EXPECT_GT(converter::area_of(hull), 0); // counter-clockwise
    std::sort(hull.begin(), hull.end());
    EXPECT_EQ(hull, slow_hull(points));
    EXPECT_EQ(converter::convex_hull({{1, 1}, {NAN, 0}, {1, 1}}),
              (std::vector<PlanePoint>{{1, 1}}));
    EXPECT_EQ(converter::convex_hull({{0, 0}, {2, 2}, {1, 1}}).size(), 2U);
    EXPECT_DOUBLE_EQ(converter::area_of({{0, 0}, {2, 0}, {2, 3}, {0, 3}}), 6);
}

TEST(GamutHull, of_the_identity_is_that_of_its_encoding) {
    const plot::Figure ucs = figures("hull-uv", {look_of(same)}).front();
    EXPECT_EQ(line_named(ucs, "it").name, "it, 1 x BT.709");
    const auto& triangle = line_named(ucs, "BT.709").points;
    for (const auto& [u, v] : line_named(ucs, "it").points) {
        double nearest = 1;
        for (std::size_t i = 0; i + 1 < triangle.size(); ++i) {
            const double dx = triangle[i + 1].first - triangle[i].first,
                         dy = triangle[i + 1].second - triangle[i].second;
            nearest = std::min(
                nearest, std::abs(dx * (v - triangle[i].second) - dy * (u - triangle[i].first)) /
                             std::hypot(dx, dy));
        }
        EXPECT_LT(nearest, 1e-6);
    }
    EXPECT_EQ(line_named(figures("hull-oklab", {look_of(same)}).front(), "it").name,
              "it, 1 x sRGB");
    EXPECT_EQ(line_named(figures("hull-oklab", {look_of(grey)}).front(), "it").name,
              "it, 0 x sRGB");
}

TEST(Panels, before_is_one_where_two_looks_take_the_same_and_two_where_not) {
    ShownLook log = look_of(same, "log");
    log.input = *lutlib::encoding_named("logc3");
    const std::vector<ShownLook> alike{look_of(same, "a"), look_of(grey, "b")},
        unlike{look_of(same, "a"), log};
    EXPECT_EQ(figures("slices", alike).front().cells.size(), 3U);
    EXPECT_EQ(figures("slices", unlike).front().cells.size(), 4U);
    EXPECT_EQ(figures("slices", unlike).front().cells[1].name, "before log");
}

TEST(Slices, show_the_codes_that_a_display_gets) {
    const plot::Figure figure = figures("slices", {look_of(squared)}).at(2);
    ASSERT_EQ(figure.cells.size(), 2U);
    const plot::Cells& before = figure.cells[0];
    ASSERT_EQ(before.colors.size(), 24U * 24U);
    EXPECT_NEAR(before.colors.front().r, 0.5 / 24, 1e-6);
    EXPECT_NEAR(before.colors.front().b, 1, 1e-6);
    EXPECT_NEAR(before.colors.back().g, 23.5 / 24, 1e-6);
    EXPECT_NEAR(figure.cells[1].colors.back().g, 23.5 / 24 * 23.5 / 24, 1e-6);
}

TEST(Gradient, of_the_neutral_axis_is_neutral_whatever_the_domain) {
    ShownLook look = look_of(same);
    look.domain = {{0, 0.25F, 0.5F}, {1, 2, 1}};
    const plot::Figure figure = figures("gradient", {look}).front();
    for (const RgbD& color : figure.cells.front().colors) {
        EXPECT_NEAR(color.r, color.g, 1e-9);
        EXPECT_NEAR(color.b, color.g, 1e-9);
    }
    EXPECT_EQ(figure.x.ticks.back().text, "2");
}

TEST(Hue, says_where_the_domain_holds_no_colour_of_it) {
    ShownLook look = look_of(same);
    look.domain = {{2, 2, 2}, {3, 3, 3}};
    EXPECT_EQ(figures("hue", {look}).front().notes.size(), 1U);
    EXPECT_TRUE(figures("hue", {look_of(same)}).front().notes.empty());
}

TEST(Skin, says_no_difference_of_the_identity) {
    const std::vector<plot::Figure> both = figures("skin", {look_of(same)});
    ASSERT_EQ(both.size(), 2U);
    for (const plot::Figure& figure : both) {
        ASSERT_GE(figure.notes.size(), 12U);
        for (const plot::Note& note : figure.notes) {
            EXPECT_TRUE(note.text == "0.0" || note.text == "before" || note.text == "it")
                << note.text;
        }
    }
    // The Monk scale's own codes.
    EXPECT_NEAR(both[0].cells[0].colors[0].r, 246 / 255.0, 1e-6);
    // L* of 56.1 and a hue of skin.
    const RgbD forehead = both[1].cells[0].colors[0];
    EXPECT_GT(forehead.r, forehead.g);
    EXPECT_GT(forehead.g, forehead.b);
}

// What cannot be drawn is left out, whatever a look makes of colours.
TEST(Panels, stand_looks_of_any_kind) {
    const std::vector<std::function<RgbD(RgbD)>> rude{
        [](RgbD) {
            return RgbD{NAN, NAN, NAN};
        },
        [](RgbD) {
            return RgbD{INFINITY, -INFINITY, 0.5};
        },
        [](RgbD) {
            return RgbD{0.5, 0.5, 0.5};
        },
        [](RgbD) {
            return RgbD{0, 0, 0};
        },
        [](RgbD c) {
            return c.r > 0.5 ? RgbD{NAN, c.g, c.b} : c;
        },
        [](RgbD c) {
            return RgbD{1e38 * c.r, -1e38 * c.g, 1e-40 * c.b};
        },
        [](RgbD c) {
            return RgbD{-c.r, -c.g, -c.b};
        }};
    const std::vector<lutlib::Domain> domains{
        {}, {{-0.5F, -0.5F, -0.5F}, {65504, 65504, 65504}}, {{2, 3, 4}, {2.001F, 3.5F, 5}}};
    const std::regex no_number("[^a-z](nan|inf)[^a-z]");
    for (const auto& f : rude) {
        for (const lutlib::Domain& domain : domains) {
            ShownLook look = look_of(f);
            look.domain = domain;
            look.output = *lutlib::encoding_named("linear");
            for (const converter::Panel* panel : converter::panels()) {
                const std::vector<ShownLook> looks{look, look_of(same, "other")};
                for (const plot::Figure& figure : panel->figures(looks)) {
                    const std::string text = svg(drawing_of(figure));
                    EXPECT_FALSE(std::regex_search(text, no_number)) << panel->name;
                }
            }
        }
    }
}

TEST(Panels, have_names_labels_and_help_of_their_own) {
    std::vector<std::string_view> names;
    for (const converter::Panel* panel : converter::panels()) {
        EXPECT_FALSE(panel->label.empty());
        EXPECT_TRUE(panel->help.ends_with('.')) << panel->help;
        EXPECT_EQ(panel->name.find(','), std::string_view::npos);
        names.push_back(panel->name);
        // Two looks have the figures of one, or one each.
        const std::vector<ShownLook> one{look_of(same)},
            two{look_of(same, "a"), look_of(grey, "b")};
        EXPECT_EQ(panel->figures(two).size() % panel->figures(one).size(), 0U) << panel->name;
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

} // namespace
} // namespace converter_test
