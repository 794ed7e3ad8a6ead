// The views of the picture in a whole frame: what they are made of, and what they leave alone.
#include "preview/finish/picture_views.h"
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "preview/reference/picture_views.h"
#include "tests/preview/frame/frame_fixture.h"

#include <algorithm>

namespace preview {
namespace {

class PictureViewFrame : public FrameTest {
  protected:
    static lutlib::RgbD color_at(const Rendered& rendered, std::size_t texel) {
        return {static_cast<double>(rendered.values[4 * texel]),
                static_cast<double>(rendered.values[4 * texel + 1]),
                static_cast<double>(rendered.values[4 * texel + 2])};
    }
    /// Twice as bright as it was: what is brighter than a half leaves the gamut.
    static lutlib::Lut doubling_look() {
        lutlib::Lut look;
        look.cube = lutlib::identity_cube(5);
        for (lutlib::Rgb& node : look.cube->nodes) {
            node = {2 * node.r, 2 * node.g, 2 * node.b};
        }
        return look;
    }
};

TEST_F(PictureViewFrame, shows_the_finished_picture_and_the_one_before_the_looks_as_the_twin_does) {
    const Loaded loaded(scene_at(*scene_named("chart"), 0));
    const GpuLook look(device(), look_for(doubling_look(), *gpu_lookup_named("tetrahedral")).data);
    FrameInputs inputs = loaded.inputs();
    inputs.look_b = &look;
    FrameSettings settings = settings_for(loaded.scene);
    settings.format = Format::rgba32f;
    settings.effects.clear(); // those behind the looks are not in what is before them
    Executor executor(device());
    const Rendered before = render_frame(executor, inputs, settings);
    settings.compare = &compare_b;
    const Rendered after = render_frame(executor, inputs, settings);
    EXPECT_FALSE(kept(after, "view of the picture")) << after.explanation;
    for (const PictureView& row : picture_views()) {
        if (row.is_picture()) {
            continue;
        }
        settings.picture_view = &row;
        const Rendered seen = render_frame(executor, inputs, settings);
        EXPECT_TRUE(kept(seen, "view of the picture")) << row.name;
        EXPECT_EQ(kept(seen, "before the looks"), row.reads_before) << row.name;
        std::size_t wrong = 0;
        for (std::size_t y = 0; y < size.height / 4; ++y) { // above the longest legend
            for (std::size_t x = 0; x < size.width; ++x) {
                const std::size_t at = y * size.width + x;
                const lutlib::RgbD expected = reference::picture_view(
                    row, {.color = color_at(after, at),
                          .before = color_at(before, at),
                          .x = static_cast<int>(x),
                          .y = static_cast<int>(y),
                          .unit = 1,
                          .level = static_cast<double>(settings.zebra_level)});
                const lutlib::RgbD got = color_at(seen, at);
                wrong += std::max({std::abs(got.r - expected.r), std::abs(got.g - expected.g),
                                   std::abs(got.b - expected.b)}) > 1e-4
                             ? 1
                             : 0;
            }
        }
        // Floats fall on the other side of a band's limit here and there.
        EXPECT_LT(wrong, size.width * size.height / 2000) << row.name;
    }
}

TEST_F(PictureViewFrame, leaves_scopes_and_heat_maps_as_they_are_and_says_why) {
    const Loaded loaded(scene_at(*scene_named("chart"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    Executor executor(device());
    const auto of = [&](std::string_view view) {
        settings.picture_view = picture_view_named(view);
        return render_frame(executor, loaded.inputs(), settings);
    };
    settings.compare = &compare_difference;
    EXPECT_EQ(of("false-color").rgba, of("picture").rgba);
    EXPECT_NE(of("false-color").explanation.find("a heat map is no picture"), std::string::npos);
    settings.compare = &compare_a;
    settings.scope = &scopes[0];
    settings.scope_sizes[0] = {128, 64};
    EXPECT_EQ(of("false-color").rgba, of("picture").rgba);
}

TEST_F(PictureViewFrame, has_the_line_of_a_comparison_over_it_and_not_in_it) {
    const Loaded loaded(scene_at(*scene_named("plain"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    settings.effects.clear();
    settings.compare = &compare_split;
    settings.picture_view = picture_view_named("false-color");
    Executor executor(device());
    const Rendered split = render_frame(executor, loaded.inputs(), settings);
    settings.compare = &compare_a;
    const Rendered alone = render_frame(executor, loaded.inputs(), settings);
    const std::size_t row = std::size_t{size.width} * 10;
    for (std::size_t x = 0; x < size.width; ++x) {
        const auto* const here = &split.rgba[4 * (row + x)];
        if (std::equal(here, here + 3, &alone.rgba[4 * (row + x)])) {
            continue;
        }
        EXPECT_NEAR(static_cast<double>(x), size.width / 2.0, 1.5);
        EXPECT_TRUE(here[0] == 255 && here[1] == 255 && here[2] == 255) << x;
    }
}

} // namespace
} // namespace preview
