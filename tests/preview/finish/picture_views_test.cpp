// The rows of the views of the picture, and what they show of colours that people know.
#include "preview/finish/picture_views.h"
#include "preview/reference/picture_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace preview {
namespace {

using lutlib::RgbD;

RgbD seen(std::string_view view, RgbD color, RgbD before = {0.5, 0.5, 0.5}) {
    return reference::picture_view(*picture_view_named(view),
                                   {.color = color, .before = before, .level = 0.95});
}

RgbD grey(double v) {
    return {v, v, v};
}

RgbD entry(std::string_view view, std::size_t at) {
    const std::array<float, 3> color = picture_view_named(view)->legend[at].color;
    return {color[0], color[1], color[2]};
}

TEST(PictureViews, have_names_twins_and_legends_that_fit_their_lines) {
    std::set<std::string_view> names;
    for (const PictureView& row : picture_views()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(&picture_views()[static_cast<std::size_t>(index_of(row))], &row);
        EXPECT_NO_THROW(reference::picture_view(row, {})) << row.name;
        EXPECT_EQ(row.legend.empty(), row.is_picture()) << row.name;
        EXPECT_LE(row.legend.size(), 8U) << row.name;
        for (const LegendEntry& line : row.legend) {
            EXPECT_LE(line.text.size(), 24U) << line.text;
            EXPECT_EQ(line.text.find_first_not_of("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ.-_+: "),
                      std::string_view::npos)
                << line.text;
        }
    }
    EXPECT_TRUE(picture_views().front().is_picture());
}

TEST(PictureViews, false_colour_marks_grey_and_the_stop_above_and_both_ends) {
    // 18 % and 36 % of the light by IEC 61966-2-1.
    const RgbD middle = seen("false-color", grey(0.4614));
    const RgbD above = seen("false-color", grey(0.6363));
    EXPECT_EQ(middle, entry("false-color", 2));
    EXPECT_EQ(above, entry("false-color", 3));
    EXPECT_EQ(seen("false-color", grey(0)), entry("false-color", 0));
    EXPECT_EQ(seen("false-color", grey(0.03)), entry("false-color", 1));
    EXPECT_EQ(seen("false-color", grey(0.98)), entry("false-color", 4));
    EXPECT_EQ(seen("false-color", grey(1)), entry("false-color", 5));
    EXPECT_EQ(seen("false-color", grey(7)), entry("false-color", 5));
    EXPECT_EQ(seen("false-color", grey(0.3)), grey(0.3)) << "between the bands it is grey";
    EXPECT_EQ(seen("false-color", grey(std::nan(""))), entry("false-color", 0));
}

TEST(PictureViews, clipping_tells_what_was_clipped_before_from_what_the_look_clips) {
    const RgbD kept{0.2, 0.5, 0.9};
    EXPECT_EQ(seen("clipping", kept), kept);
    EXPECT_EQ(seen("clipping", {0.2, 0.5, 1}, {1.5, 0.5, 0.5}), entry("clipping", 0));
    EXPECT_EQ(seen("clipping", {0.2, 0.5, 1}), entry("clipping", 1));
    EXPECT_EQ(seen("clipping", {0.2, 0, 0.5}, {0.2, -0.1, 0.5}), entry("clipping", 2));
    EXPECT_EQ(seen("clipping", {0.2, 0, 0.5}), entry("clipping", 3));
    // What rounds to the last code is at its end; the code beside is not.
    EXPECT_EQ(seen("clipping", {0.2, 0.5, 254.6 / 255}), entry("clipping", 1));
    EXPECT_EQ(seen("clipping", {0.2, 0.5, 254.4 / 255}), (RgbD{0.2, 0.5, 254.4 / 255}));
}

TEST(PictureViews, gamut_marks_what_lies_outside_and_not_what_lies_on_the_hull) {
    EXPECT_EQ(seen("gamut", {1, 0, 1}), grey(0.5 * (0.2126 + 0.0722)));
    EXPECT_EQ(seen("gamut", {1.01, 0, 1}), entry("gamut", 1));
    EXPECT_EQ(seen("gamut", {0.5, -0.01, 1}), entry("gamut", 1));
    EXPECT_EQ(seen("gamut", {0.5, -0.01, 1}, {0.5, 0.5, 1.2}), entry("gamut", 0));
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_EQ(seen("gamut", {inf, 0, 0}), entry("gamut", 1));
}

TEST(PictureViews, channels_are_grey_pictures) {
    const RgbD color{0.8, 0.2, 0.4};
    EXPECT_EQ(seen("red", color), grey(0.8));
    EXPECT_EQ(seen("green", color), grey(0.2));
    EXPECT_EQ(seen("blue", color), grey(0.4));
    EXPECT_NEAR(seen("luma", color).g, 0.2126 * 0.8 + 0.7152 * 0.2 + 0.0722 * 0.4, 1e-12);
    EXPECT_EQ(seen("saturation", color), grey((0.8 - 0.2) / 0.8));
    EXPECT_EQ(seen("saturation", grey(0)), grey(0));
    EXPECT_EQ(seen("saturation", grey(0.7)), grey(0));
}

TEST(PictureViews, zebra_has_stripes_from_its_level_on) {
    const PictureView& zebra = *picture_view_named("zebra");
    const auto at = [&](int x, double code) {
        return reference::picture_view(
            zebra, {.color = grey(code), .before = {}, .x = x, .y = 0, .unit = 1, .level = 0.5});
    };
    EXPECT_EQ(at(0, 0.49), grey(0.49));
    EXPECT_EQ(at(0, 0.5), grey(0));
    EXPECT_EQ(at(3, 0.5), grey(1));
    EXPECT_EQ(at(6, 0.5), grey(0));
}

} // namespace
} // namespace preview
