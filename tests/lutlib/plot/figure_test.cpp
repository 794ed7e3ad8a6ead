// Figures on linear axes, as SVG and as pixels.
#include "lutlib/plot/dot_font.h"
#include "lutlib/plot/figure.h"
#include "lutlib/plot/figure_sheet.h"
#include "lutlib/plot/palette.h"
#include "lutlib/plot/raster_shapes.h"
#include "tests/lutlib/plot/markup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

namespace plot {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Figure figure_of(const std::vector<std::pair<double, double>>& points) {
    Figure out;
    out.title = "Curve";
    out.x.label = "in";
    out.y.label = "out";
    Line line;
    line.name = "it";
    line.color = 1;
    line.points = points;
    out.lines = {line};
    return out;
}

std::vector<Stroke> strokes_of(const Drawing& drawing, Rgb8 color) {
    std::vector<Stroke> out;
    for (const Shape& shape : drawing.shapes) {
        const Stroke* const stroke = std::get_if<Stroke>(&shape);
        if (stroke && stroke->color == color) {
            out.push_back(*stroke);
        }
    }
    return out;
}

std::vector<std::string> texts_of(const Drawing& drawing) {
    std::vector<std::string> out;
    for (const Shape& shape : drawing.shapes) {
        if (const Words* const words = std::get_if<Words>(&shape)) {
            out.push_back(words->text);
        }
    }
    return out;
}

TEST(Extent, holds_what_is_finite_and_is_never_empty_for_an_axis) {
    Extent none;
    none.add(nan);
    none.add(infinity);
    EXPECT_TRUE(none.is_empty());
    EXPECT_EQ(none.with_width().low, 0);
    EXPECT_EQ(none.with_width().high, 1);
    for (const double value : {0.0, 0.5, -3.0, 1e300, -1e300, 1e-310}) {
        Extent one;
        one.add(value);
        const Extent wide = one.with_width();
        EXPECT_LT(wide.low, wide.high) << value;
        EXPECT_TRUE(std::isfinite(wide.high - wide.low)) << value;
    }
    constexpr double most = std::numeric_limits<double>::max();
    const Extent all = Extent{-most, most}.with_width();
    EXPECT_TRUE(std::isfinite(2 * (all.high - all.low)));
}

TEST(RoundValues, lie_between_the_ends_and_are_one_two_or_five_times_a_power_of_ten_apart) {
    for (const Extent& range :
         {Extent{0, 1}, Extent{-0.3, 0.41}, Extent{17, 17.001}, Extent{-4e9, 2e12}}) {
        const std::vector<double> values = round_values(range, 6);
        ASSERT_GE(values.size(), 2U) << range.low;
        EXPECT_LE(values.size(), 7U);
        const double step = values[1] - values[0];
        const double digit = step / std::pow(10, std::floor(std::log10(step) + 1e-6));
        EXPECT_TRUE(std::abs(digit - 1) < 1e-3 || std::abs(digit - 2) < 1e-3 ||
                    std::abs(digit - 5) < 1e-3)
            << digit;
        for (const double value : values) {
            EXPECT_GE(value, range.low - 1e-6 * step);
            EXPECT_LE(value, range.high + 1e-6 * step);
        }
    }
    EXPECT_EQ(value_text(-1e-17, {-1, 1}), "0");
    EXPECT_EQ(value_text(0.30000000000000004, {0, 1}), "0.3");
}

TEST(Figure, draws_equal_steps_of_values_as_equal_steps) {
    const Drawing drawing = drawing_of(figure_of({{0, 0}, {1, 2}, {2, 4}}));
    const std::vector<Stroke> lines = strokes_of(drawing, series_color(1));
    ASSERT_EQ(lines.size(), 2U); // itself and in the legend
    const std::vector<Point>& p = lines.front().points;
    ASSERT_EQ(p.size(), 3U);
    EXPECT_NEAR(p[1].x - p[0].x, p[2].x - p[1].x, 1e-9);
    EXPECT_NEAR(p[1].y - p[0].y, p[2].y - p[1].y, 1e-9);
    EXPECT_GT(p[2].x, p[0].x);
    EXPECT_LT(p[2].y, p[0].y); // up
}

TEST(Figure, of_same_units_is_as_long_upwards_as_to_the_right) {
    Figure square = figure_of({{0, 0}, {1, 1}, {0, 5}});
    square.same_units = true;
    const std::vector<Stroke> lines = strokes_of(drawing_of(square), series_color(1));
    const std::vector<Point>& p = lines.front().points;
    EXPECT_NEAR(p[1].x - p[0].x, p[0].y - p[1].y, 1e-9);
}

TEST(Figure, keeps_all_of_it_within_its_frame_and_interrupts_a_line_at_what_is_no_number) {
    Figure figure =
        figure_of({{0, 0}, {0.5, nan}, {1, 1}, {2, infinity}, {3, -1.7e308}, {4, 1.7e308}});
    figure.cells = {{"c", 0, 4, -1, 1, 2, 1, {{0, 0, 0}, {nan, 0, 0}}}};
    figure.dots = {{"d", {{2, 0, {2, -1, 0.5}}}}};
    figure.notes = {{2, 0, "note"}};
    const Drawing drawing = drawing_of(figure);
    const std::string text = svg(drawing);
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_EQ(text.find("inf"), std::string::npos) << text;
    EXPECT_EQ(unbalanced_element(text), "");
    EXPECT_EQ(all_of(text, "(<rect )").size(), 1U); // the cell that has no colour is not drawn
    EXPECT_NE(text.find("fill=\"#ff0080\""), std::string::npos); // held to 0..1
    const std::string path =
        all_of(text, "stroke=\"" + css_color(series_color(1)) + "\"[^>]* d=\"([^\"]+)\"").front();
    EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 3) << path;
    for (const Stroke& stroke : strokes_of(drawing, series_color(1))) {
        for (const Point& p : stroke.points) {
            EXPECT_FALSE(p.x < 0 || p.x > drawing.width || p.y < 0 || p.y > drawing.height);
        }
    }
}

TEST(Figure, says_its_words_and_escapes_them) {
    Figure figure = figure_of({{0, 0}, {1, 1}});
    const std::string rude = "<b>\"A\" & B</b>";
    figure.title = figure.x.label = figure.y.label = figure.lines[0].name = rude;
    const std::string text = svg(drawing_of(figure));
    EXPECT_EQ(text.find(rude), std::string::npos);
    EXPECT_EQ(all_of(text, "(&lt;b&gt;&quot;A&quot; &amp; B&lt;/b&gt;)").size(), 6U);
    figure.x.ticks = {{0, "lowest"}, {1, "highest"}};
    const std::vector<std::string> texts = texts_of(drawing_of(figure));
    EXPECT_EQ(std::count(texts.begin(), texts.end(), "lowest"), 1);
}

TEST(Figure, is_the_same_in_pixels_as_in_svg) {
    const Drawing drawing = drawing_of(figure_of({{0, 0}, {1, 1}, {2, 0.5}}));
    const int scale = 3;
    const Raster pixels = raster(drawing, static_cast<int>(drawing.width) * scale);
    EXPECT_EQ(pixels.height(), static_cast<int>(drawing.height) * scale);
    const Stroke line = strokes_of(drawing, series_color(1)).front();
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        for (const double t : {0.25, 0.5, 0.75}) {
            const double x = std::lerp(line.points[i].x, line.points[i + 1].x, t) * scale;
            const double y = std::lerp(line.points[i].y, line.points[i + 1].y, t) * scale;
            EXPECT_EQ(pixels.at(static_cast<int>(x), static_cast<int>(y)), series_color(1));
        }
    }
    std::size_t inked = 0;
    for (const Rgb8& pixel : pixels.pixels()) {
        inked += pixel != drawing_ground;
    }
    EXPECT_GT(inked, 3000U); // axes and text too
}

TEST(Figure, has_no_seam_between_colours_at_any_size) {
    Figure figure;
    figure.has_axes = false;
    // Where a border lies between two pixels, sums in another order round to the other side.
    const double width = (960.0 - 8) / 3 - 8;
    for (const int columns : {12, 24, 128}) {
        figure.cells = {{"c", 0, 1, 0, 1, columns, 1,
                         std::vector<lutlib::RgbD>(static_cast<std::size_t>(columns))}};
        Drawing sheet;
        sheet.width = 960;
        sheet.height = 240;
        sheet.add(drawing_of(figure, width), {8 + 2 * (width + 8), 0});
        for (const int pixels : {960, 1920}) {
            const Raster out = raster(sheet, pixels);
            // Of a row through the middle, what is dark is in one piece.
            const int y = out.height() / 2;
            int changes = 0;
            for (int x = 1; x < out.width(); ++x) {
                changes += out.at(x, y) != out.at(x - 1, y);
            }
            EXPECT_EQ(changes, 2) << columns << ' ' << pixels;
        }
    }
}

// How much of a pixel a line covers, by looking at 32 x 32 places in it.
double covered(Point a, Point b, double width, int x, int y) {
    constexpr int places = 32;
    int inside = 0;
    for (int i = 0; i < places * places; ++i) {
        const double px = x + (i % places + 0.5) / places, py = y + (i / places + 0.5) / places;
        const double dx = b.x - a.x, dy = b.y - a.y;
        const double t =
            std::clamp(((px - a.x) * dx + (py - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        inside += std::hypot(a.x + t * dx - px, a.y + t * dy - py) <= width / 2;
    }
    return inside / double{places * places};
}

TEST(RasterShapes, cover_what_a_line_covers) {
    const std::array<std::array<Point, 2>, 4> lines{{{{{3, 10.5}, {17, 10.5}}},
                                                     {{{10, 3}, {10, 17}}},
                                                     {{{4, 4}, {16, 16}}},
                                                     {{{3, 8}, {17, 13}}}}};
    for (const auto& line : lines) {
        for (const double width : {1.0, 2.6}) {
            Raster out(20, 20, {255, 255, 255});
            draw_line(out, line, width, {0, 0, 0});
            for (int y = 0; y < 20; ++y) {
                for (int x = 0; x < 20; ++x) {
                    const double share = 1 - out.at(x, y)[0] / 255.0;
                    // The distance of a pixel's middle stands for its area: by a seventh at most.
                    EXPECT_NEAR(share, covered(line[0], line[1], width, x, y), 0.15)
                        << x << " " << y << " " << width;
                }
            }
        }
    }
}

TEST(RasterShapes, draw_nothing_outside_and_stand_far_places) {
    Raster out(8, 8, {255, 255, 255});
    draw_line(out, std::array<Point, 2>{{{-1e12, 4}, {1e12, 4}}}, 1, {0, 0, 0});
    draw_disc(out, {-100, -100}, 5, {0, 0, 0});
    draw_line(out, {}, 1, {0, 0, 0});
    EXPECT_EQ(out.at(4, 1), (Rgb8{255, 255, 255}));
    EXPECT_LT(out.at(4, 4)[0], 160);
}

TEST(Dashes, are_as_long_as_they_are_asked_to_be_and_go_round_corners) {
    const std::vector<Point> corner{{0, 0}, {10, 0}, {10, 10}, {nan, 0}, {20, 0}, {21, 0}};
    const auto dashes = dashes_of(corner, 4, 3);
    ASSERT_EQ(dashes.size(), 4U);
    double length = 0;
    for (const auto& dash : dashes) {
        for (std::size_t i = 0; i + 1 < dash.size(); ++i) {
            length += std::hypot(dash[i + 1].x - dash[i].x, dash[i + 1].y - dash[i].y);
        }
    }
    // Three of 4 in 20, which end in a gap; and one of 1.
    EXPECT_NEAR(length, 4 * 3 + 1, 1e-9);
    EXPECT_EQ(dashes[1].size(), 3U); // by way of the corner
    EXPECT_EQ(pieces_of(corner).size(), 2U);
}

TEST(FigureSheet, keeps_the_order_and_gives_what_is_wide_a_row_of_its_own) {
    std::vector<Figure> figures(5, figure_of({{0, 0}, {1, 1}}));
    for (std::size_t i = 0; i < figures.size(); ++i) {
        figures[i].title = "figure " + std::to_string(i);
    }
    figures[2].is_wide = true;
    const std::vector<std::string> headlines{"head"};
    const Drawing sheet = figure_sheet(headlines, figures, 960);
    std::vector<Point> at;
    for (const Shape& shape : sheet.shapes) {
        const Words* const words = std::get_if<Words>(&shape);
        if (words && words->text.starts_with("figure ")) {
            at.push_back(words->at);
        }
    }
    ASSERT_EQ(at.size(), 5U);
    EXPECT_EQ(at[0].y, at[1].y);
    EXPECT_GT(at[1].x, at[0].x);
    EXPECT_GT(at[2].y, at[1].y);
    EXPECT_GT(at[3].y, at[2].y);
    EXPECT_EQ(at[3].y, at[4].y);
    EXPECT_EQ(sheet.label, "head");
    for (const int pixels : {320, 640, 1000, 1920, 4096}) {
        const Drawing any = figure_sheet(headlines, figures, sheet_dots(pixels, figures));
        EXPECT_EQ(raster(any, pixels).width(), pixels);
        // A dot of text is a whole number of pixels.
        const double scale = pixels / any.width;
        EXPECT_NEAR(scale, std::round(scale), 1e-9) << pixels;
    }
}

TEST(Drawing, alone_is_a_file_of_its_own) {
    Drawing drawing = drawing_of(figure_of({{0, 0}, {1, 1}}));
    const std::string text = svg(drawing, 608);
    EXPECT_NE(text.find("xmlns=\"http://www.w3.org/2000/svg\" width=\"608\" height=\"456\""),
              std::string::npos)
        << text.substr(0, 200);
    EXPECT_EQ(svg(drawing).find("xmlns"), std::string::npos);
}

TEST(Text, is_cut_between_characters) {
    const std::string text = "\xc3\xa4\xc3\xb6\xc3\xbc-0123456789";
    EXPECT_EQ(text_cut_in_the_middle(text, 99), text);
    EXPECT_EQ(text_cut_in_the_middle(text, 8), "\xc3\xa4\xc3\xb6\xc3\xbc...89");
    for (std::size_t most = 0; most < 14; ++most) {
        EXPECT_EQ(glyphs_of(text_cut_in_the_middle(text, most)),
                  cut_in_the_middle(glyphs_of(text), most))
            << most;
    }
}

} // namespace
} // namespace plot
