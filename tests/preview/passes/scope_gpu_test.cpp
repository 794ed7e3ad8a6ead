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

ScopeArea all_of(std::uint32_t width, std::uint32_t height) {
    return {.width = width, .height = height};
}

class EveryScope : public FinishTest, public testing::WithParamInterface<Scope> {
  protected:
    struct Result {
        std::vector<std::uint32_t> counts;
        RgbaCodes picture; ///< the drawing
    };

    static Result run(const RgbaCodes& codes, std::uint32_t width, const ScopeArea& area,
                      const ScopeDrawing& drawn) {
        const auto height = static_cast<std::uint32_t>(codes.size() / 4 / width);
        const gpu::Image image = upload({Format::rgba8, width, height}, codes);
        Graph graph;
        const ScopePicture out =
            add_scope(graph, graph.import("codes", image, image.desc()), GetParam(), area, drawn);
        graph.present(out.counts);
        graph.present(out.picture);
        Executor executor(device());
        executor.render(graph);
        return {as<std::uint32_t>(executor.read_buffer(out.counts)),
                as<std::uint8_t>(executor.read_image(out.picture))};
    }

    static std::vector<std::uint32_t> wanted(const RgbaCodes& codes, std::uint32_t width,
                                             const ScopeArea& area, Size size) {
        return reference::scope_counts(GetParam(), codes, width, area,
                                       scope_columns(GetParam(), area, {size}));
    }
};

constexpr Size drawing{301, 203};

TEST_P(EveryScope, counts_what_its_twin_counts_and_each_texel_once_in_each_plane) {
    struct Picture {
        std::uint32_t width, height;
        ScopeArea area;
    };
    for (const Picture& picture : {Picture{1, 1, all_of(1, 1)},
                                   {1, 37, all_of(1, 37)},
                                   {613, 1, all_of(613, 1)},
                                   {257, 131, all_of(257, 131)},
                                   {640, 400, all_of(640, 400)},
                                   {257, 131, {.x = 100, .width = 33, .height = 131}},
                                   {257, 131, {.x = 100, .y = 20, .width = 33, .height = 110}},
                                   {257, 131, {.x = 256, .y = 130, .width = 1, .height = 1}},
                                   {64, 64, {.x = 63, .width = 1, .height = 64}}}) {
        SCOPED_TRACE(std::to_string(picture.width) + "x" + std::to_string(picture.height));
        const RgbaCodes codes = noise(picture.width, picture.height, picture.width);
        const auto got = run(codes, picture.width, picture.area, {drawing}).counts;
        EXPECT_EQ(got, wanted(codes, picture.width, picture.area, drawing));
        const std::uint64_t planes = GetParam().bins == ScopeBins::chroma ? 1 : GetParam().planes;
        EXPECT_EQ(std::accumulate(got.begin(), got.end(), std::uint64_t{0}),
                  planes * picture.area.width * picture.area.height);
    }
}

// Every way in which a comparison divides a picture, at angles that no texel's edge has.
TEST_P(EveryScope, counts_one_side_of_any_border_as_its_twin_does) {
    constexpr std::uint32_t width = 257, height = 131;
    const RgbaCodes codes = noise(width, height, 5);
    const std::uint64_t planes = GetParam().bins == ScopeBins::chroma ? 1 : GetParam().planes;
    for (const Compare* compare : {&compare_split, &compare_box}) {
        for (const float angle : {0.0F, 17.3F, 45.0F, 90.0F, 211.7F, 270.0F}) {
            const Wipe wipe{.split = 0.41F, .split_angle = angle, .box_width = angle / 300};
            for (std::size_t side = 1; side < scope_sides.size(); ++side) {
                SCOPED_TRACE(std::string(compare->name) + " " + std::to_string(angle) + " " +
                             std::string(scope_sides[side].name));
                const ScopeArea area =
                    scope_area(scope_sides[side], *compare, wipe, {}, {width, height});
                if (area.is_empty()) {
                    EXPECT_EQ(angle, 0) << "a box without width has no inside";
                    continue;
                }
                const auto got = run(codes, width, area, {drawing}).counts;
                EXPECT_EQ(got, wanted(codes, width, area, drawing));
                std::uint64_t texels = 0;
                for (std::uint32_t i = 0; i < area.width * area.height; ++i) {
                    texels += is_counted(area, area.x + i % area.width, area.y + i / area.width);
                }
                EXPECT_EQ(std::accumulate(got.begin(), got.end(), std::uint64_t{0}),
                          planes * texels);
            }
        }
    }
}

TEST_P(EveryScope, counts_a_rectangle_in_both_pictures_side_by_side) {
    constexpr std::uint32_t width = 2 * 90, height = 40;
    const RgbaCodes codes = noise(width, height, 9);
    const ScopeArea area{.x = 7, .y = 3, .width = 31, .height = 20, .copies = 2, .stride = 90};
    const auto got = run(codes, width, area, {drawing}).counts;
    EXPECT_EQ(got, wanted(codes, width, area, drawing));
    const std::uint64_t planes = GetParam().bins == ScopeBins::chroma ? 1 : GetParam().planes;
    EXPECT_EQ(std::accumulate(got.begin(), got.end(), std::uint64_t{0}),
              planes * 2 * area.width * area.height);
}

TEST_P(EveryScope, counts_black_white_and_full_colors_in_their_outermost_places) {
    for (const std::array<std::uint8_t, 4>& code :
         std::vector<std::array<std::uint8_t, 4>>{{0, 0, 0, 0},
                                                  {255, 255, 255, 255},
                                                  {255, 0, 0, 0},
                                                  {0, 0, 255, 255},
                                                  {0, 255, 0, 0}}) {
        const RgbaCodes codes = flat(300, 70, code);
        const auto got = run(codes, 300, all_of(300, 70), {drawing}).counts;
        EXPECT_EQ(got, wanted(codes, 300, all_of(300, 70), drawing));
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
    const ScopeArea area = all_of(size.width, size.height);
    const ScopePicture scope = add_scope(graph, picture, GetParam(), area, {drawing});
    graph.present(picture);
    graph.present(scope.counts);
    Executor executor(device());
    executor.render(graph);
    EXPECT_EQ(as<std::uint32_t>(executor.read_buffer(scope.counts)),
              wanted(as<std::uint8_t>(executor.read_image(picture)), size.width, area, drawing));
}

TEST_P(EveryScope, draws_in_any_size_and_another_picture_for_other_codes) {
    const RgbaCodes dark = flat(40, 30, {20, 24, 60, 255}), bright = noise(40, 30, 3);
    for (const Size size : {Size{1, 1}, {7, 3}, {64, 200}, {640, 360}}) {
        for (const bool logarithmic : {false, true}) {
            const auto a = run(dark, 40, all_of(40, 30), {size, logarithmic}).picture;
            ASSERT_EQ(a.size(), std::size_t{4} * size.width * size.height);
            if (size.width == 640) {
                EXPECT_NE(a, run(bright, 40, all_of(40, 30), {size, logarithmic}).picture);
            }
        }
    }
}

// Others write them over the picture then, in the room that is left for them.
TEST_P(EveryScope, has_its_own_figures_unless_room_for_others_is_asked_for) {
    const RgbaCodes codes = flat(40, 30, {20, 20, 20, 255});
    const auto inked = [&](const ScopeDrawing& drawn) {
        const RgbaCodes picture = run(codes, 40, all_of(40, 30), drawn).picture;
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
    const RgbaCodes clipped = run(thirds({0, 128, 255}), 30, all_of(30, 10), {drawing}).picture;
    const RgbaCodes whole = run(thirds({1, 128, 254}), 30, all_of(30, 10), {drawing}).picture;
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

TEST_P(EveryScope, is_brighter_or_higher_by_each_step_of_its_gain) {
    const RgbaCodes codes = noise(300, 200, 5);
    for (const bool logarithmic : {false, true}) {
        std::uint64_t last = 0;
        for (const ScopeGain& gain : scope_gains) {
            ScopeDrawing drawn{drawing, logarithmic};
            drawn.gain = gain.factor;
            const RgbaCodes picture = run(codes, 300, {.width = 300, .height = 200}, drawn).picture;
            const auto light = std::accumulate(picture.begin(), picture.end(), std::uint64_t{0});
            EXPECT_GT(light, last) << gain.name;
            last = light;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Table, EveryScope, testing::ValuesIn(scopes),
                         [](const auto& row) { return std::string(row.param.name); });

class VectorscopeTest : public EveryScope {};

// Where colours of the line's hue are counted, too: Cb and Cr at 123 degrees.
TEST_F(VectorscopeTest, has_the_skin_line_at_123_degrees_with_its_name_beyond_the_circle) {
    constexpr int length = 400;
    const Scope& scope = *std::find_if(scopes.begin(), scopes.end(), [](const Scope& row) {
        return row.bins == ScopeBins::chroma;
    });
    const gpu::Image image = upload({Format::rgba8, 8, 8}, flat(8, 8, {0, 0, 0, 255}));
    Graph graph;
    const ImageHandle out = add_scope(graph, graph.import("black", image, image.desc()), scope,
                                      {0, 0, 8, 8}, {{length, length}})
                                .picture;
    graph.present(out);
    const RgbaCodes picture = run_and_read<std::uint8_t>(graph, out);
    const ScopePlot plot = scope_plot(scope, length, length);
    const double scale = plot.width / 1.06;
    /// Of Cb and Cr at that angle, in shares of the circle's radius: how much redder than blue.
    const auto warmth = [&](double degrees, double share) {
        const double angle = degrees / 180 * 3.14159265358979;
        const auto x = static_cast<std::size_t>(plot.x + 0.5 * plot.width +
                                                std::cos(angle) * share * 0.5 * scale);
        const auto y = static_cast<std::size_t>(plot.y + 0.5 * plot.height -
                                                std::sin(angle) * share * 0.5 * scale);
        return picture[4 * (y * length + x)] - picture[4 * (y * length + x) + 2];
    };
    for (const double share : {0.2, 0.4, 0.85}) {
        EXPECT_GT(warmth(123, share), 40) << share;
        EXPECT_LT(warmth(123 + 8 / share / 10, share), 20) << share;
        EXPECT_LT(warmth(123 - 8 / share / 10, share), 20) << share;
        EXPECT_LT(warmth(123 + 180, share), 20) << "the line has one side";
    }
    const auto labels = scope_labels(scope, plot, dotted_figures(plot));
    const ScopeLabel& skin = labels.back();
    EXPECT_EQ(skin.text, "Skin");
    const double x = skin.x - plot.x - 0.5 * plot.width, y = plot.y + 0.5 * plot.height - skin.y;
    EXPECT_GT(std::hypot(x, y), 0.5 * scale);
    int inked = 0;
    for (int row = skin.y; row < skin.y + 6 * plot.dot; ++row) {
        for (int column = skin.x; column < skin.x + 24 * plot.dot; ++column) {
            const std::size_t at =
                4 * (static_cast<std::size_t>(row) * length + static_cast<std::size_t>(column));
            inked += picture[at] == 184 && picture[at + 1] == 163 ? 1 : 0;
        }
    }
    EXPECT_GT(inked, 30);
}

TEST(ScopeTwinTest, luma_and_differences_lie_within_half_a_code_of_bt709) {
    for (int r = 0; r < 256; r += 15) {
        for (int g = 0; g < 256; g += 15) {
            for (int b = 0; b < 256; b += 15) {
                const RgbaCodes code{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                                     static_cast<std::uint8_t>(b), 0};
                const double luma = 0.2126 * r + 0.7152 * g + 0.0722 * b;
                const auto waveform = reference::scope_counts(scopes[0], code, 1, all_of(1, 1), 1);
                const auto level =
                    std::find(waveform.begin(), waveform.end(), 1U) - waveform.begin();
                // Half a code of rounding, and 3 weights that are each 2^-17 off.
                EXPECT_NEAR(static_cast<double>(level), luma, 0.506);
                const auto chroma = reference::scope_counts(scopes[3], code, 1, all_of(1, 1), 1);
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
