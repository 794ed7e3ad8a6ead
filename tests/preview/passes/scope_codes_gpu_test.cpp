// The codes that scopes count in another encoding, on a device: every one as the twin has it in
// double.
#include "preview/passes/scope_codes.h"

#include "preview/finish/scopes.h"
#include "preview/passes/scope.h"
#include "preview/reference/scopes.h"
#include "tests/preview/passes/finish_fixture.h"

#include <algorithm>

namespace preview {
namespace {

using RgbaCodes = std::vector<std::uint8_t>;
constexpr std::uint32_t side = 128;

lutlib::Encoding named(std::string_view name) {
    return *lutlib::encoding_named(name);
}

/// Every grey, every code of a channel alone and with the others full, and as many others as fit.
const RgbaCodes& colors() {
    static const RgbaCodes codes = [] {
        RgbaCodes out;
        for (int code = 0; code < 256; ++code) {
            for (int mask = 1; mask < 8; ++mask) {
                for (const int other : {0, 255}) {
                    for (int c = 0; c < 3; ++c) {
                        out.push_back(
                            static_cast<std::uint8_t>((mask >> c & 1) != 0 ? code : other));
                    }
                    out.push_back(255);
                }
            }
        }
        std::uint32_t state = 1;
        while (out.size() < std::size_t{4} * side * side) {
            state = state * 747796405U + 2891336453U;
            out.insert(out.end(), {static_cast<std::uint8_t>(state >> 24),
                                   static_cast<std::uint8_t>(state >> 16),
                                   static_cast<std::uint8_t>(state >> 8), 255});
        }
        return out;
    }();
    return codes;
}

class ScopeCodes : public FinishTest, public testing::WithParamInterface<lutlib::Encoding> {
  protected:
    static RgbaCodes encoded(const ScopeLevels& levels) {
        const gpu::Image image = upload({Format::rgba8, side, side}, colors());
        Graph graph;
        const ImageHandle out =
            add_scope_codes(graph, graph.import("codes", image, image.desc()), levels);
        graph.present(out);
        return run_and_read<std::uint8_t>(graph, out);
    }
};

TEST_P(ScopeCodes, are_those_of_lutlibs_curves_of_every_shown_encoding) {
    for (const char* const shown :
         {"srgb", "srgb/p3-d65", "gamma24/rec709", "pq", "hlg", "slog3"}) {
        const ScopeLevels levels{GetParam(), named(shown), 203};
        EXPECT_EQ(encoded(levels), reference::scope_codes(colors(), levels))
            << GetParam().name() << " of " << shown;
    }
}

INSTANTIATE_TEST_SUITE_P(Table, ScopeCodes, testing::ValuesIn(lutlib::encodings()),
                         [](const auto& row) {
                             std::string name(row.param.curve->name);
                             std::replace_if(
                                 name.begin(), name.end(), [](char c) { return c == '-'; }, '_');
                             return name;
                         });

using ScopeCodesOf = ScopeCodes;

// Of 8-bit levels, the nearest.
TEST_F(ScopeCodesOf, pq_put_the_displays_white_at_its_luminance_and_hlg_at_three_quarters) {
    const auto white = [](const char* name, float nits) {
        const RgbaCodes one{255, 255, 255, 255};
        return reference::scope_codes(one, {named(name), lutlib::srgb(), nits});
    };
    EXPECT_EQ(white("pq", 100), (RgbaCodes{130, 130, 130, 255}));  // .5081
    EXPECT_EQ(white("pq", 203), (RgbaCodes{148, 148, 148, 255}));  // .5807
    EXPECT_EQ(white("pq", 1000), (RgbaCodes{192, 192, 192, 255})); // .7518
    EXPECT_EQ(white("hlg", 100), (RgbaCodes{191, 191, 191, 255}));
    EXPECT_EQ(white("linear", 203), (RgbaCodes{255, 255, 255, 255}));
}

// A frame's scope of them, drawn: the trace of white stands at the line of 100 cd/m2.
TEST_F(ScopeCodesOf, pq_stand_in_the_waveform_where_their_luminance_is_written) {
    constexpr std::uint32_t width = 64, height = 64;
    const RgbaCodes white(std::size_t{4} * width * height, 255);
    const gpu::Image image = upload({Format::rgba8, width, height}, white);
    const ScopeLevels levels{named("pq"), lutlib::srgb(), 100};
    const Scope& waveform = *scopes.begin();
    ScopeDrawing drawing{{400, 420}};
    drawing.levels = levels;
    Graph graph;
    const ImageHandle codes =
        add_scope_codes(graph, graph.import("white", image, image.desc()), levels);
    const ImageHandle out =
        add_scope(graph, codes, waveform, {.width = width, .height = height}, drawing).picture;
    graph.present(out);
    const RgbaCodes picture = run_and_read<std::uint8_t>(graph, out);
    const std::vector<LevelFigure> figures = level_figures(levels);
    const ScopePlot plot = scope_plot(waveform, 400, 420, std::nullopt, figures);
    int brightest = 0, row = 0;
    for (int y = plot.y; y < plot.y + plot.height; ++y) {
        const int green = picture[4 * (static_cast<std::size_t>(y) * 400 +
                                       static_cast<std::size_t>(plot.x + plot.width / 2)) +
                                  1];
        row = green > brightest ? y : row;
        brightest = std::max(brightest, green);
    }
    const auto figure = std::find_if(figures.begin(), figures.end(),
                                     [](const LevelFigure& one) { return one.text == "100"; });
    ASSERT_NE(figure, figures.end());
    EXPECT_NEAR(plot.y + plot.height * (1 - figure->at), row, 2);
    const auto is_red = [&](int y) {
        return picture[4 * (static_cast<std::size_t>(y) * 400 + 300)] > 200;
    };
    EXPECT_FALSE(is_red(plot.y)) << "nothing of 100 cd/m2 is clipped in PQ";
}

} // namespace
} // namespace preview
