// A part of the picture on a device against its twin in double, and in a whole frame.
#include "preview/passes/magnify.h"
#include "preview/reference/magnify.h"
#include "preview/scene/gpu_scene.h"
#include "tests/preview/frame/frame_fixture.h"

#include <random>

namespace preview {
namespace {

class MagnifyTest : public FrameTest {
  protected:
    static constexpr Size of_picture{37, 21}, of_output{64, 48};

    static reference::Image noise(int width, int height) {
        reference::Image out(width, height);
        std::mt19937 numbers(3); // NOLINT: the same on every machine
        for (lutlib::RgbD& pixel : out.pixels) {
            for (std::size_t c = 0; c < 3; ++c) {
                pixel[c] = static_cast<double>(numbers() % 1024) / 512 - 0.5;
            }
        }
        return out;
    }
    static std::vector<float> texels_of(const reference::Image& picture) {
        std::vector<float> out;
        for (const lutlib::RgbD& pixel : picture.pixels) {
            for (std::size_t c = 0; c < 3; ++c) {
                out.push_back(static_cast<float>(pixel[c]));
            }
            out.push_back(1);
        }
        return out;
    }
    static void expect_near(const std::vector<float>& got, const reference::Image& expected,
                            const std::string& what) {
        ASSERT_EQ(got.size(), expected.pixels.size() * 4);
        double worst = 0;
        for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                worst = std::max(
                    worst, std::abs(static_cast<double>(got[4 * i + c]) - expected.pixels[i][c]));
            }
        }
        EXPECT_LT(worst, 1e-4) << what; // a float's place between texels, times a step of 2
    }
};

TEST_F(MagnifyTest, shows_what_its_twin_does_at_every_scale_and_place) {
    const reference::Image picture = noise(37, 21);
    const gpu::Image image = upload({Format::rgba32f, 37, 21}, texels_of(picture));
    for (const float scale : {1.0F, 1.75F, 2.0F, 8.0F}) {
        for (const float middle : {0.0F, 0.45F, 1.0F}) {
            for (const Magnifier& magnifier : magnifiers) {
                const Zoom zoom{scale, middle, middle, &magnifier};
                const ZoomPlace place = zoom_place(zoom, of_picture, of_picture, of_output);
                Graph graph;
                const ImageHandle out =
                    add_magnify(graph, graph.import("picture", image, image.desc()),
                                {.place = place, .magnifier = &magnifier, .output = of_output});
                graph.present(out);
                expect_near(run_and_read<float>(graph, out),
                            reference::magnified(
                                picture, {place.left, place.top, static_cast<double>(place.scale)},
                                &magnifier == &magnifier_smooth, static_cast<double>(surround_code),
                                64, 48),
                            std::string(magnifier.name) + " " + std::to_string(scale));
            }
        }
    }
}

TEST_F(MagnifyTest, shows_each_of_two_pictures_side_by_side_in_its_own_half) {
    const reference::Image picture = noise(74, 21);
    const gpu::Image image = upload({Format::rgba32f, 74, 21}, texels_of(picture));
    const ZoomPlace place = zoom_place({.scale = 3, .x = 1}, of_picture, of_picture, of_output);
    Graph graph;
    const ImageHandle out = add_magnify(graph, graph.import("picture", image, image.desc()),
                                        {.place = place, .output = of_output, .is_pair = true});
    graph.present(out);
    const auto got = run_and_read<float>(graph, out);
    for (int side = 0; side < 2; ++side) {
        reference::Image half(37, 21);
        for (int y = 0; y < 21; ++y) {
            for (int x = 0; x < 37; ++x) {
                half.at(x, y) = picture.at(x + 37 * side, y);
            }
        }
        const reference::Image expected = reference::magnified(
            half, {place.left, place.top, 3}, false, static_cast<double>(surround_code), 64, 48);
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) {
                ASSERT_EQ(got[static_cast<std::size_t>(4 * (y * 128 + x + 64 * side))],
                          static_cast<float>(expected.at(x, y).r))
                    << x << ' ' << y;
            }
        }
    }
}

TEST_F(MagnifyTest, shows_a_pictures_own_pixels_at_1_to_1_and_tells_the_colour_under_the_mouse) {
    const reference::Image picture = noise(300, 200);
    const GpuPicture shown(device(), {300, 200}, texels_of(picture), true);
    FrameInputs inputs;
    inputs.picture = &shown;
    FrameSettings settings;
    settings.output = {300, 200};
    settings.compare = &compare_a;
    settings.format = Format::rgba32f;
    Executor executor(device());
    const Rendered whole = render_frame(executor, inputs, settings);
    settings.output = {80, 60};
    settings.zoom = {.scale = 1, .x = 0.25F, .y = 0.5F};
    settings.probe = ProbePlace{10, 20};
    const Rendered part = render_frame(executor, inputs, settings);
    EXPECT_TRUE(kept(part, "magnify")) << part.explanation;
    EXPECT_FALSE(kept(whole, "magnify"));
    ASSERT_EQ(part.size, settings.output);
    const auto at = [](const Rendered& from, std::size_t x, std::size_t y) {
        return from.values[4 * (y * from.size.width + x)];
    };
    for (std::size_t y = 0; y < 60; ++y) {
        for (std::size_t x = 0; x < 80; ++x) {
            ASSERT_EQ(at(part, x, y), at(whole, x + 35, y + 70)) << x << ' ' << y;
        }
    }
    ASSERT_TRUE(part.probe);
    EXPECT_EQ(static_cast<float>(part.probe->before.r), at(whole, 45, 90));
    // Eight pixels each: the same texel under all of them.
    settings.zoom.scale = 8;
    const Rendered large = render_frame(executor, inputs, settings);
    EXPECT_EQ(at(large, 40, 30), at(large, 47, 37));
    EXPECT_EQ(static_cast<float>(large.probe->before.r), at(large, 10, 20));
}

TEST_F(MagnifyTest, draws_line_scale_and_legend_over_what_is_seen_and_not_into_it) {
    const Loaded loaded(scene_at(*scene_named("plain"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    settings.effects.clear();
    settings.zoom = {.scale = 4, .x = 0.5F, .y = 0.5F};
    settings.split = 0.55F;
    settings.compare = &compare_split;
    Executor executor(device());
    const Rendered split = render_frame(executor, loaded.inputs(), settings);
    settings.compare = &compare_a;
    const Rendered alone = render_frame(executor, loaded.inputs(), settings);
    // Of 160 columns four times as large the line is at 352, of which 240 are left of what is seen.
    for (std::size_t x = 0; x < size.width; ++x) {
        const std::size_t texel = 4 * (std::size_t{size.width} * 10 + x);
        const bool differs = split.rgba[texel] != alone.rgba[texel];
        EXPECT_EQ(differs, x == 111 || x == 112) << x;
    }
    settings.compare = &compare_difference;
    const Rendered heat = render_frame(executor, loaded.inputs(), settings);
    std::size_t white = 0;
    for (std::size_t i = 0; i < heat.rgba.size(); i += 4) {
        white += heat.rgba[i] == 255 && heat.rgba[i + 1] == 255 && heat.rgba[i + 2] == 255 ? 1 : 0;
    }
    EXPECT_GT(white, 10U) << "the scale has no figures";
    EXPECT_LT(white, 200U) << "they are as large as the picture's pixels";
    settings.compare = &compare_a;
    settings.picture_view = picture_view_named("false-color");
    const Rendered viewed = render_frame(executor, loaded.inputs(), settings);
    EXPECT_TRUE(kept(viewed, "view of the picture"));
    EXPECT_EQ(viewed.size, size);
}

} // namespace
} // namespace preview
