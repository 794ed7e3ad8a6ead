// Where the scopes' figures stand.
#include "preview/finish/scopes.h"

#include <gtest/gtest.h>

#include <string>

namespace preview {
namespace {

class FiguresOf : public testing::TestWithParam<Scope> {};

TEST_P(FiguresOf, lie_in_the_picture_beside_plots_of_levels_and_apart_from_each_other) {
    for (const auto& [width, height] : {std::array{640U, 360U}, {1024U, 512U}, {200U, 180U}}) {
        for (const FigureSize font : {FigureSize{}, {7, 13}, {14, 26}}) {
            SCOPED_TRACE(std::to_string(width) + " " + std::to_string(font.height));
            const bool has_own = font == FigureSize{};
            const ScopePlot plot =
                scope_plot(GetParam(), width, height,
                           has_own ? std::nullopt : std::optional<FigureSize>(font));
            const FigureSize figures = has_own ? dotted_figures(plot) : font;
            const auto labels = scope_labels(GetParam(), plot, figures);
            const auto right = [&](const ScopeLabel& label) {
                return label.x + static_cast<int>(label.text.size()) * figures.advance;
            };
            const bool is_tight =
                GetParam().bins == ScopeBins::levels && width == 200 && font.height == 26;
            EXPECT_EQ(labels.size(), GetParam().bins == ScopeBins::chroma ? 7U
                                     : is_tight                           ? 3U
                                                                          : 5U);
            for (const ScopeLabel& label : labels) {
                SCOPED_TRACE(label.text);
                EXPECT_GE(label.x, 0);
                EXPECT_GE(label.y, 0);
                EXPECT_LE(right(label), static_cast<int>(width));
                EXPECT_LE(label.y + figures.height, static_cast<int>(height));
                if (GetParam().bins != ScopeBins::chroma) {
                    EXPECT_TRUE(right(label) <= plot.x || label.y >= plot.y + plot.height);
                }
                for (const ScopeLabel& other : labels) {
                    EXPECT_TRUE(&other == &label || right(other) <= label.x ||
                                right(label) <= other.x || other.y + figures.height <= label.y ||
                                label.y + figures.height <= other.y)
                        << other.text;
                }
            }
        }
    }
}

// Five characters at heights that are not even.
TEST_P(FiguresOf, of_pq_have_room_and_the_uppermost_is_always_there) {
    if (!has_levels(GetParam())) {
        return;
    }
    const std::vector<LevelFigure> levels = level_figures({*lutlib::encoding_named("pq")});
    for (const auto& [width, height] : {std::array{640U, 360U}, {1024U, 512U}, {200U, 180U}}) {
        for (const FigureSize font : {FigureSize{7, 13}, {14, 26}}) {
            SCOPED_TRACE(std::to_string(width) + " " + std::to_string(font.height));
            const ScopePlot plot = scope_plot(GetParam(), width, height, font, levels);
            const auto labels = scope_labels(GetParam(), plot, font, levels);
            ASSERT_GE(labels.size(), 2U);
            EXPECT_EQ(labels.back().text, "10000");
            for (std::size_t i = 0; i < labels.size(); ++i) {
                const int right =
                    labels[i].x + static_cast<int>(labels[i].text.size()) * font.advance;
                EXPECT_GE(labels[i].x, 0) << labels[i].text;
                if (GetParam().bins == ScopeBins::columns) {
                    EXPECT_LT(right, plot.x);
                    EXPECT_TRUE(i == 0 || labels[i].y + font.height <= labels[i - 1].y);
                } else {
                    EXPECT_LE(right, static_cast<int>(width));
                    EXPECT_TRUE(i + 1 == labels.size() || right <= labels[i + 1].x);
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Table, FiguresOf, testing::ValuesIn(scopes),
                         [](const auto& row) { return std::string(row.param.name); });

} // namespace
} // namespace preview
