// The views of the picture on a device against their twins in double.
#include "preview/passes/picture_view.h"
#include "preview/reference/picture_views.h"
#include "tests/preview/passes/finish_fixture.h"

#include <algorithm>

namespace preview {
namespace {

class PictureViewTest : public FinishTest {
  protected:
    // Too narrow for any legend.
    static constexpr std::uint32_t width = 32;
    static constexpr float level = 0.7F;

    static std::vector<lutlib::Rgb> shown(const PictureView& row,
                                          const std::vector<lutlib::Rgb>& colors,
                                          const std::vector<lutlib::Rgb>& before) {
        const gpu::Image image = image_of(colors, width), other = image_of(before, width);
        Graph graph;
        const ImageHandle out = add_picture_view(
            graph,
            {graph.import("picture", image, image.desc()),
             row.reads_before ? graph.import("before", other, other.desc()) : ImageHandle{}},
            row, level, Format::rgba32f);
        graph.present(out);
        auto result = colors_of(run_and_read<float>(graph, out));
        result.resize(colors.size());
        return result;
    }

    static double distance(const lutlib::Rgb& a, const lutlib::RgbD& b) {
        return std::max({std::abs(static_cast<double>(a.r) - b.r),
                         std::abs(static_cast<double>(a.g) - b.g),
                         std::abs(static_cast<double>(a.b) - b.b)});
    }
};

TEST_F(PictureViewTest, every_row_shows_what_its_twin_does) {
    const std::vector<lutlib::Rgb> colors = test_colors(5);
    std::vector<lutlib::Rgb> before(colors.rbegin(), colors.rend());
    for (const PictureView& row : picture_views()) {
        if (row.is_picture()) {
            continue;
        }
        const std::vector<lutlib::Rgb> out = shown(row, colors, before);
        int wrong = 0;
        for (std::size_t i = 0; i < colors.size(); ++i) {
            // Sums in float fall on the other side of a limit here and there: what is shown is what
            // the twin shows of the colour or of one a millionth beside it.
            const auto at = [&](double by) {
                const auto moved = [&](const lutlib::Rgb& c) {
                    return lutlib::RgbD{static_cast<double>(c.r) + by,
                                        static_cast<double>(c.g) + by,
                                        static_cast<double>(c.b) + by};
                };
                return reference::picture_view(row, {.color = moved(colors[i]),
                                                     .before = moved(before[i]),
                                                     .x = static_cast<int>(i % width),
                                                     .y = static_cast<int>(i / width),
                                                     .unit = 1,
                                                     .level = static_cast<double>(level)});
            };
            const double nearest = std::min(
                {distance(out[i], at(0)), distance(out[i], at(-1e-6)), distance(out[i], at(1e-6))});
            if (!(nearest <= 2e-6) && ++wrong < 5) {
                ADD_FAILURE() << row.name << ' ' << colors[i].r << ' ' << colors[i].g << ' '
                              << colors[i].b << ": " << out[i].r << ' ' << out[i].g << ' '
                              << out[i].b;
            }
        }
        EXPECT_EQ(wrong, 0) << row.name;
    }
}

TEST_F(PictureViewTest, has_its_legend_in_the_lower_left_corner_where_it_fits) {
    const std::vector<lutlib::Rgb> grey(std::size_t{320} * 180, {0.3F, 0.3F, 0.3F});
    const gpu::Image image = image_of(grey, 320);
    for (const PictureView& row : picture_views()) {
        if (row.is_picture()) {
            continue;
        }
        Graph graph;
        const ImageHandle source = graph.import("picture", image, image.desc());
        const ImageHandle out =
            add_picture_view(graph, {source, source}, row, level, Format::rgba8);
        graph.present(out);
        const auto codes = run_and_read<std::uint8_t>(graph, out);
        const auto has = [&](const std::array<float, 3>& color) {
            for (std::size_t y = 90; y < 180; ++y) {
                for (std::size_t x = 0; x < 160; ++x) {
                    const std::size_t at = 4 * (y * 320 + x);
                    if (std::equal(color.begin(), color.end(), &codes[at], [](float c, int code) {
                            return std::lround(c * 255) == code;
                        })) {
                        return true;
                    }
                }
            }
            return false;
        };
        for (const LegendEntry& entry : row.legend) {
            EXPECT_TRUE(has(entry.color)) << row.name << ' ' << entry.text;
        }
        // Elsewhere the picture is looked at: one colour.
        for (std::size_t at = 4; at < std::size_t{4} * 320 * 90; ++at) {
            ASSERT_EQ(codes[at], codes[at % 4]) << row.name;
        }
    }
}

} // namespace
} // namespace preview
