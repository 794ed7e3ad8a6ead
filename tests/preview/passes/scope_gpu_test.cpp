// The scopes on a device: every count against the twin's, and what their pictures must show.
#include "preview/passes/scope.h"
#include "preview/reference/scopes.h"
#include "tests/preview/passes/finish_fixture.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace preview {
namespace {

using RgbaCodes = std::vector<std::uint8_t>;

/// Codes that differ from texel to texel, with flat areas between; the alpha is noise.
RgbaCodes noise(std::uint32_t width, std::uint32_t height, std::uint32_t seed) {
    RgbaCodes codes;
    std::uint32_t state = seed * 747796405U + 2891336453U;
    for (std::uint32_t i = 0; i < 4 * width * height; ++i) {
        state = state * 747796405U + 2891336453U;
        const bool flat = i / 4 / 7 % 3 == 0;
        codes.push_back(static_cast<std::uint8_t>(flat ? 200 - 40 * (i % 4) : state >> 24));
    }
    return codes;
}

RgbaCodes flat(std::uint32_t width, std::uint32_t height, std::array<std::uint8_t, 4> code) {
    RgbaCodes codes;
    for (std::uint32_t i = 0; i < width * height; ++i) {
        codes.insert(codes.end(), code.begin(), code.end());
    }
    return codes;
}

class EveryScope : public FinishTest, public testing::WithParamInterface<Scope> {
  protected:
    struct Result {
        std::vector<std::uint32_t> counts;
        RgbaCodes picture; ///< the drawing
    };

    static Result run(const RgbaCodes& codes, std::uint32_t width, ColumnRange range,
                      const ScopeDrawing& drawn) {
        const auto height = static_cast<std::uint32_t>(codes.size() / 4 / width);
        const gpu::Image image = upload({Format::rgba8, width, height}, codes);
        Graph graph;
        const ScopePicture out =
            add_scope(graph, graph.import("codes", image, image.desc()), GetParam(), range, drawn);
        graph.present(out.counts);
        graph.present(out.picture);
        Executor executor(device());
        executor.render(graph);
        return {as<std::uint32_t>(executor.read_buffer(out.counts)),
                as<std::uint8_t>(executor.read_image(out.picture))};
    }

    static std::vector<std::uint32_t> wanted(const RgbaCodes& codes, std::uint32_t width,
                                             ColumnRange range, Size size) {
        return reference::scope_counts(GetParam(), codes, width, range,
                                       scope_columns(GetParam(), range, {size}));
    }
};

constexpr Size drawing{301, 203};

TEST_P(EveryScope, counts_what_its_twin_counts_and_each_texel_once_in_each_plane) {
    struct Picture {
        std::uint32_t width, height;
        ColumnRange range;
    };
    for (const Picture& picture : {Picture{1, 1, {0, 1}},
                                   {1, 37, {0, 1}},
                                   {613, 1, {0, 613}},
                                   {257, 131, {0, 257}},
                                   {640, 400, {0, 640}},
                                   {257, 131, {100, 33}},
                                   {64, 64, {63, 1}}}) {
        SCOPED_TRACE(std::to_string(picture.width) + "x" + std::to_string(picture.height));
        const RgbaCodes codes = noise(picture.width, picture.height, picture.width);
        const auto got = run(codes, picture.width, picture.range, {drawing}).counts;
        EXPECT_EQ(got, wanted(codes, picture.width, picture.range, drawing));
        const std::uint64_t planes = GetParam().bins == ScopeBins::chroma ? 1 : GetParam().planes;
        EXPECT_EQ(std::accumulate(got.begin(), got.end(), std::uint64_t{0}),
                  planes * picture.range.count * picture.height);
    }
}

TEST_P(EveryScope, counts_black_white_and_full_colors_in_their_outermost_places) {
    for (const std::array<std::uint8_t, 4>& code :
         std::vector<std::array<std::uint8_t, 4>>{{0, 0, 0, 0},
                                                  {255, 255, 255, 255},
                                                  {255, 0, 0, 0},
                                                  {0, 0, 255, 255},
                                                  {0, 255, 0, 0}}) {
        const RgbaCodes codes = flat(300, 70, code);
        const auto got = run(codes, 300, {0, 300}, {drawing}).counts;
        EXPECT_EQ(got, wanted(codes, 300, {0, 300}, drawing));
        if (GetParam().bins == ScopeBins::chroma && code[0] == code[1] && code[1] == code[2]) {
            EXPECT_EQ(got[128 * 256 + 128], 300U * 70);
        }
    }
}

// What comes out of the finishing pass for NaN, infinite and negative light is some code, and
// counts as that.
TEST_P(EveryScope, counts_the_codes_that_broken_light_became) {
    const std::vector<lutlib::Rgb> colors = test_colors(2);
    const gpu::Image image = image_of(colors);
    Graph graph;
    const ImageHandle picture =
        add_finish(graph, {graph.import("colours", image, image.desc()), {}, nullptr, nullptr, {}})
            .picture;
    const Size size = size_of(graph, picture);
    const ColumnRange range{0, size.width};
    const ScopePicture scope = add_scope(graph, picture, GetParam(), range, {drawing});
    graph.present(picture);
    graph.present(scope.counts);
    Executor executor(device());
    executor.render(graph);
    EXPECT_EQ(as<std::uint32_t>(executor.read_buffer(scope.counts)),
              wanted(as<std::uint8_t>(executor.read_image(picture)), size.width, range, drawing));
}

TEST_P(EveryScope, draws_in_any_size_and_another_picture_for_other_codes) {
    const RgbaCodes dark = flat(40, 30, {20, 24, 60, 255}), bright = noise(40, 30, 3);
    for (const Size size : {Size{1, 1}, {7, 3}, {64, 200}, {640, 360}}) {
        for (const bool logarithmic : {false, true}) {
            const auto a = run(dark, 40, {0, 40}, {size, logarithmic}).picture;
            ASSERT_EQ(a.size(), std::size_t{4} * size.width * size.height);
            if (size.width == 640) {
                EXPECT_NE(a, run(bright, 40, {0, 40}, {size, logarithmic}).picture);
            }
        }
    }
}

// Others write them over the picture then, in the room that is left for them.
TEST_P(EveryScope, has_its_own_figures_unless_room_for_others_is_asked_for) {
    const RgbaCodes codes = flat(40, 30, {20, 20, 20, 255});
    const auto inked = [&](const ScopeDrawing& drawn) {
        const RgbaCodes picture = run(codes, 40, {0, 40}, drawn).picture;
        int count = 0;
        for (std::size_t i = 0; i < picture.size(); i += 4) {
            count += picture[i] == 184 && picture[i + 1] == 163 && picture[i + 2] == 117 ? 1 : 0;
        }
        return count;
    };
    EXPECT_GT(inked({drawing}), 40);
    EXPECT_EQ(inked({drawing, true, FigureSize{7, 13}}), 0);
}

// Left black, in the middle grey, right white.
TEST_P(EveryScope, marks_clipped_texels_where_they_are_and_nothing_else) {
    if (GetParam().bins == ScopeBins::chroma) {
        return; // it has no levels
    }
    const auto thirds = [](std::array<int, 3> codes) {
        RgbaCodes out;
        for (int i = 0; i < 30 * 10; ++i) {
            const auto code =
                static_cast<std::uint8_t>(codes[static_cast<std::size_t>(i % 30 / 10)]);
            out.insert(out.end(), {code, code, code, 255});
        }
        return out;
    };
    const ScopePlot plot = scope_plot(GetParam(), drawing.width, drawing.height);
    const auto is_red = [&](const RgbaCodes& picture, int x, int y) {
        const std::size_t at = (static_cast<std::size_t>(y) * drawing.width + x) * 4;
        return picture[at] > 200 && picture[at + 1] < 100 && picture[at + 2] < 100;
    };
    const auto is_blue = [&](const RgbaCodes& picture, int x, int y) {
        const std::size_t at = (static_cast<std::size_t>(y) * drawing.width + x) * 4;
        return picture[at] < 100 && picture[at + 2] > 200;
    };
    const RgbaCodes clipped = run(thirds({0, 128, 255}), 30, {0, 30}, {drawing}).picture;
    const RgbaCodes whole = run(thirds({1, 128, 254}), 30, {0, 30}, {drawing}).picture;
    const int left = plot.x + 1, right = plot.x + plot.width - 2, top = plot.y;
    const int middle = plot.x + plot.width / 2;
    const int bottom = GetParam().bins == ScopeBins::levels ? top : plot.y + plot.height - 1;
    EXPECT_TRUE(is_blue(clipped, left, bottom));
    EXPECT_TRUE(is_red(clipped, right, top));
    EXPECT_FALSE(is_red(clipped, middle, top));
    EXPECT_FALSE(is_blue(clipped, middle, bottom));
    EXPECT_FALSE(is_blue(whole, left, bottom));
    EXPECT_FALSE(is_red(whole, right, top));
}

INSTANTIATE_TEST_SUITE_P(Table, EveryScope, testing::ValuesIn(scopes),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(ScopeRangeTest, of_a_side_has_no_column_of_the_other_nor_of_the_line) {
    constexpr std::uint32_t width = 200, height = 2160;
    const ScopeSide &a = scope_sides[1], &b = scope_sides[2];
    for (const Compare& compare : compares) {
        for (const float split : {0.0F, 0.3F, 0.5F, 1.0F}) {
            SCOPED_TRACE(std::string(compare.name) + " " + std::to_string(split));
            const auto range = [&](const ScopeSide& side) {
                return scope_range(side, compare, split, width, height);
            };
            const bool heat = &compare == &compare_difference;
            EXPECT_EQ(range(scope_side_shown), heat ? ColumnRange{} : (ColumnRange{0, width}));
            EXPECT_LE(range(a).first + range(a).count, width);
            EXPECT_LE(range(b).first + range(b).count, width);
            if (heat || !compare.shows_a || !compare.shows_b) {
                EXPECT_EQ(range(a).count, compare.shows_a && !heat ? width : 0);
                EXPECT_EQ(range(b).count, compare.shows_b && !heat ? width : 0);
                continue;
            }
            EXPECT_LE(range(a).count, range(b).first);
            if (&compare == &compare_side) {
                EXPECT_EQ(range(a), (ColumnRange{0, 100}));
                EXPECT_EQ(range(b), (ColumnRange{100, 100}));
            } else if (split == 0.5F) {
                // The line is four texels wide at 2160 lines; antialiasing takes one more each
                // side.
                EXPECT_EQ(range(a), (ColumnRange{0, 97}));
                EXPECT_EQ(range(b), (ColumnRange{103, 97}));
            } else if (split == 0.0F) {
                EXPECT_EQ(range(a).count, 0U);
            } else if (split == 1.0F) {
                EXPECT_EQ(range(b).count, 0U);
            }
        }
    }
}

TEST(ScopeTwinTest, luma_and_differences_lie_within_half_a_code_of_bt709) {
    for (int r = 0; r < 256; r += 15) {
        for (int g = 0; g < 256; g += 15) {
            for (int b = 0; b < 256; b += 15) {
                const RgbaCodes code{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                                     static_cast<std::uint8_t>(b), 0};
                const double luma = 0.2126 * r + 0.7152 * g + 0.0722 * b;
                const auto waveform = reference::scope_counts(scopes[0], code, 1, {0, 1}, 1);
                const auto level =
                    std::find(waveform.begin(), waveform.end(), 1U) - waveform.begin();
                // Half a code of rounding, and 3 weights that are each 2^-17 off.
                EXPECT_NEAR(static_cast<double>(level), luma, 0.506);
                const auto chroma = reference::scope_counts(scopes[3], code, 1, {0, 1}, 1);
                const auto place = std::find(chroma.begin(), chroma.end(), 1U) - chroma.begin();
                // The largest difference, 127.5, rounds to a code that 8 bits do not have.
                EXPECT_NEAR(static_cast<double>(place % 256) - 128, (b - luma) / 1.8556, 0.506);
                EXPECT_NEAR(static_cast<double>(place / 256) - 128, (r - luma) / 1.5748, 0.506);
            }
        }
    }
}

} // namespace
} // namespace preview
