// Skies and pictures as surroundings on a device, against the double twins.
#include "lutlib/half.h"
#include "preview/passes/surroundings.h"
#include "preview/reference/noise.h"
#include "preview/reference/surroundings.h"
#include "tests/preview/frame/frame_fixture.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace preview {
namespace {

constexpr Size small{64, 36};

/// A ball that the camera does not see.
Scene empty_scene() {
    Scene scene;
    scene.meshes.push_back(sphere(4, 8));
    scene.materials.push_back({});
    Object ball;
    ball.transform = glm::translate(glm::mat4(1), {0, 0, 50});
    scene.objects.push_back(ball);
    scene.orbit = {{0, 0, 0}, 5, 20, -8, 70, 0.1F};
    return scene;
}

class SurroundingsTest : public FrameTest {
  protected:
    static FrameSettings light_settings(const Scene& scene) {
        FrameSettings settings;
        settings.output = small;
        settings.orbit = scene.orbit;
        settings.view = debug_view_named("lit");
        settings.shows_numbers = true;
        settings.format = Format::rgba32f;
        settings.shadow_size = 64;
        return settings;
    }

    /// Light of the picture, four floats a pixel.
    static std::vector<float> light(const FrameInputs& inputs, const FrameSettings& settings) {
        // One for all tests: pipelines take longer to make than such pictures.
        static Executor executor(device());
        return render_frame(executor, inputs, settings).values;
    }

    static glm::dvec3 ray_of(const Scene& scene, std::uint32_t x, std::uint32_t y) {
        const ViewBlock view = view_block(scene.orbit, 16.0F / 9);
        const double sx = (x + 0.5) / small.width * 2 - 1;
        const double sy = (y + 0.5) / small.height * 2 - 1;
        return glm::normalize(glm::dvec3(view.forward) + sx * glm::dvec3(view.right) +
                              sy * glm::dvec3(view.up));
    }

    static reference::Image image_of(Executor& executor, ImageHandle handle, Size size) {
        const auto halves = as<std::uint16_t>(executor.read_image(handle));
        reference::Image out(static_cast<int>(size.width), static_cast<int>(size.height));
        for (std::size_t at = 0; at < out.pixels.size(); ++at) {
            for (std::size_t c = 0; c < 3; ++c) {
                out.pixels[at][c] =
                    static_cast<double>(lutlib::float_from_half(halves[4 * at + c]));
            }
        }
        return out;
    }
};

TEST_F(SurroundingsTest, a_sky_is_the_double_twins_at_every_height_of_the_sun) {
    Scene scene = empty_scene();
    scene.surroundings.kind = SurroundingsKind::sky;
    for (const float height : {50.0F, 2.0F, -8.0F}) {
        scene.surroundings.sky.sun_height = height;
        scene.surroundings.sky.sun_azimuth = 150; // behind the camera
        const Loaded loaded(scene);
        const std::vector<float> pixels = light(loaded.inputs(), light_settings(scene));
        const SkyBlock block = sky_block(scene.surroundings.sky);
        for (std::uint32_t y = 0; y < small.height; ++y) {
            for (std::uint32_t x = 0; x < small.width; ++x) {
                const glm::dvec3 ray = ray_of(scene, x, y);
                const glm::dvec3 expected = sky_radiance(block, ray);
                for (int c = 0; c < 3; ++c) {
                    // Halves are truncated twice, and floats of the ray meet a steep horizon.
                    const double bound = (std::abs(ray.y) < 0.004 ? 0.02 : 0.004) *
                                         std::max({expected.x, expected.y, expected.z});
                    EXPECT_NEAR(pixels[4 * (std::size_t{y} * small.width + x) +
                                       static_cast<std::size_t>(c)],
                                expected[c], bound)
                        << height << ' ' << x << ' ' << y;
                }
            }
        }
    }
}

TEST_F(SurroundingsTest, the_suns_disc_blooms_and_stays_finite_at_any_exposure) {
    Scene scene = empty_scene();
    scene.surroundings.kind = SurroundingsKind::sky;
    scene.surroundings.sky.sun_height = 30;
    scene.orbit.azimuth = 0;
    scene.orbit.elevation = -30;
    scene.orbit.field_of_view = 5;
    scene.surroundings.sky.sun_azimuth = 0;
    const Loaded loaded(scene);
    for (const float exposure : {-10.0F, 6.0F}) {
        FrameSettings settings = light_settings(scene);
        settings.exposure = exposure;
        settings.view = debug_view_named("hdr");
        const std::vector<float> pixels = light(loaded.inputs(), settings);
        const std::size_t middle =
            4 * (std::size_t{small.height} / 2 * small.width + small.width / 2);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_LT(pixels[middle + c], 65504) << exposure;
            EXPECT_GT(pixels[middle + c], 10 * pixels[c]) << exposure;
            EXPECT_GT(pixels[middle + c], exposure < 0 ? 10 : 1000) << exposure;
        }
        EXPECT_GT(pixels[middle], pixels[middle + 2]) << "a low sun is yellow";
    }
}

TEST_F(SurroundingsTest, what_surfaces_take_of_it_is_the_double_twins) {
    Surroundings surroundings;
    surroundings.kind = SurroundingsKind::sky;
    surroundings.sky.sun_height = 20;
    constexpr Size texels{16, 8};
    SurroundingsInputs inputs;
    inputs.base = texels;
    Graph graph;
    const SurroundingsHandles handles = add_surroundings(graph, surroundings, inputs);
    for (const ImageHandle image : {handles.base, handles.levels, handles.reflectance}) {
        graph.present(image);
    }
    graph.present(handles.harmonics);
    Executor executor(device());
    executor.render(graph);
    const reference::Image base = image_of(executor, handles.base, texels);
    const Size stack{texels.width, texels.height * surroundings_levels};
    const reference::Image levels = image_of(executor, handles.levels, stack);
    // Drivers may cut off where a shader leaves the rounding to half floats to them: 3.5e-4.
    lutlib::RgbD sum, sum_expected;
    for (int level = 0; level < static_cast<int>(surroundings_levels); ++level) {
        for (int y = 0; y < base.height; ++y) {
            for (int x = 0; x < base.width; ++x) {
                const glm::dvec3 axis =
                    reference::sphere_direction((x + 0.5) / base.width, (y + 0.5) / base.height);
                const lutlib::RgbD expected = reference::mirrored(
                    base, axis, (level + 1.0) / static_cast<double>(surroundings_levels));
                sum = sum + levels.at(x, y + level * base.height);
                sum_expected = sum_expected + expected;
                for (std::size_t c = 0; c < 3; ++c) {
                    EXPECT_NEAR(levels.at(x, y + level * base.height)[c], expected[c],
                                0.002 * expected[c] + 1e-6)
                        << level << ' ' << x << ' ' << y;
                }
            }
        }
    }
    const SkyBlock sky = sky_block(surroundings.sky);
    lutlib::RgbD sum_base, sum_sky;
    for (int y = 0; y < base.height; ++y) {
        for (int x = 0; x < base.width; ++x) {
            sum_base = sum_base + base.at(x, y);
            for (int i = 0; i < 16; ++i) { // 4x4 directions
                const glm::dvec3 light = sky_radiance(
                    sky, reference::sphere_direction((x + (i % 4 + 0.5) / 4) / base.width,
                                                     (y + (i / 4 + 0.5) / 4) / base.height));
                sum_sky = sum_sky + lutlib::RgbD{light.x, light.y, light.z} * (1.0 / 16);
            }
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(sum[c], sum_expected[c], 1e-4 * sum_expected[c]);
        EXPECT_NEAR(sum_base[c], sum_sky[c], 1e-4 * sum_sky[c]);
    }
    const auto harmonics = as<float>(executor.read_buffer(handles.harmonics));
    const auto expected = reference::irradiance_harmonics(base);
    for (std::size_t which = 0; which < 9; ++which) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(harmonics[4 * which + c], expected[which][c], 1e-5);
        }
    }
    // Order 2 holds a sky's irradiance to a few per cent of the brightest.
    const double brightest = reference::irradiance(base, {0, 1, 0}).g;
    for (const glm::dvec3 normal : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0),
                                    glm::dvec3(0.6, 0, -0.8), glm::dvec3(-0.48, 0.6, 0.64)}) {
        EXPECT_NEAR(reference::irradiance(expected, normal).g,
                    reference::irradiance(base, normal).g, 0.06 * brightest);
    }
    constexpr Size nodes{32, 32};
    const reference::Image table = image_of(executor, handles.reflectance, nodes);
    for (int y = 0; y < 32; y += 5) {
        for (int x = 0; x < 32; x += 5) {
            const reference::Reflectance twin =
                reference::reflectance(y / 31.0, std::max(x / 31.0, 0.001), 64);
            EXPECT_NEAR(table.at(x, y).r, twin.scale, 0.002) << x << ' ' << y;
            EXPECT_NEAR(table.at(x, y).g, twin.bias, 0.002) << x << ' ' << y;
        }
    }
}

TEST_F(SurroundingsTest, white_balls_vanish_in_a_white_furnace_whatever_their_roughness) {
    Scene scene = empty_scene();
    scene.meshes.push_back(sphere(16, 32));
    scene.orbit = {{0, 0, 0}, 10, 0, 0, 40, 0.1F};
    for (int column = 0; column < 6; ++column) {
        for (int row = 0; row < 2; ++row) {
            Object ball;
            ball.mesh = 1;
            ball.material = static_cast<std::uint32_t>(scene.materials.size());
            ball.transform =
                glm::scale(glm::translate(glm::mat4(1), {2.0F * static_cast<float>(column) - 5,
                                                         2.4F * static_cast<float>(row) - 1.2F, 0}),
                           glm::vec3(0.9F));
            scene.materials.push_back(
                {glm::vec3(1), 0.2F * static_cast<float>(column), static_cast<float>(row), {}});
            scene.objects.push_back(ball);
        }
    }
    scene.surroundings.kind = SurroundingsKind::picture;
    scene.surroundings.rotation = 40;
    const Loaded loaded(scene);
    const GpuPicture white(device(), {8, 4}, std::vector<float>(std::size_t{4} * 8 * 4, 1.0F),
                           false);
    FrameInputs inputs = loaded.inputs();
    inputs.surroundings_picture = &white;
    const std::vector<float> pixels = light(inputs, light_settings(scene));
    for (std::size_t at = 0; at < pixels.size(); ++at) {
        EXPECT_NEAR(pixels[at], 1, 0.01) << at / 4 % small.width << ' ' << at / 4 / small.width;
    }
}

TEST_F(SurroundingsTest, a_picture_turns_to_the_right_and_takes_its_exposure) {
    Scene scene = empty_scene();
    scene.orbit = {{0, 0, 0}, 5, 0, 0, 40, 0.1F};
    scene.surroundings.kind = SurroundingsKind::picture;
    scene.surroundings.exposure = 1;
    // Red ahead, green to the right, blue behind, white to the left.
    std::vector<float> rgba;
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x) {
            const int side = ((x + 2) / 4) % 4; // 0 behind, 1 left, 2 ahead, 3 right
            rgba.insert(rgba.end(),
                        {side == 2 || side == 1 ? 1.0F : 0.0F, side == 3 || side == 1 ? 1.0F : 0.0F,
                         side == 0 || side == 1 ? 1.0F : 0.0F, 1.0F});
        }
    }
    const GpuPicture picture(device(), {16, 8}, rgba, false);
    const std::size_t middle = 4 * (std::size_t{small.height} / 2 * small.width + small.width / 2);
    const std::array<std::array<float, 3>, 3> expected{{{2, 0, 0}, {2, 2, 2}, {0, 2, 0}}};
    const float turns[] = {0, 90, -90}; // turned to the right, what was to the left is ahead
    for (std::size_t i = 0; i < 3; ++i) {
        scene.surroundings.rotation = turns[i];
        const Loaded loaded(scene);
        FrameInputs inputs = loaded.inputs();
        inputs.surroundings_picture = &picture;
        const std::vector<float> pixels = light(inputs, light_settings(scene));
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(pixels[middle + c], expected[i][c], 0.002) << turns[i] << ' ' << c;
        }
    }
}

TEST_F(SurroundingsTest, noise_is_the_double_twins_and_moves_with_time) {
    Scene scene = empty_scene();
    scene.surroundings.kind = SurroundingsKind::noise;
    std::vector<float> before;
    for (const double seconds : {7.3, -1e5}) {
        scene.surroundings.seconds = seconds;
        const Loaded loaded(scene);
        const std::vector<float> pixels = light(loaded.inputs(), light_settings(scene));
        EXPECT_NE(pixels, before);
        before = pixels;
        for (std::uint32_t y = 0; y < small.height; ++y) {
            for (std::uint32_t x = 0; x < small.width; ++x) {
                const lutlib::RgbD expected =
                    reference::noise_background(noise_now(scene.surroundings), ray_of(scene, x, y));
                for (std::size_t c = 0; c < 3; ++c) {
                    EXPECT_NEAR(pixels[4 * (std::size_t{y} * small.width + x) + c], expected[c],
                                0.003 * expected[c] + 3e-4)
                        << seconds << ' ' << x << ' ' << y;
                }
            }
        }
    }
}

TEST_F(SurroundingsTest, are_made_when_the_sun_moves_and_only_then) {
    Scene scene = empty_scene();
    scene.surroundings.kind = SurroundingsKind::sky;
    Executor executor(device());
    const Loaded loaded(scene);
    FrameInputs inputs = loaded.inputs();
    Surroundings surroundings = scene.surroundings;
    inputs.surroundings = &surroundings;
    FrameSettings settings = light_settings(scene);
    const auto made = [&] {
        const Rendered rendered = render_frame(executor, inputs, settings);
        return kept(rendered, "surroundings levels") || kept(rendered, "surroundings base") ||
               kept(rendered, "surroundings irradiance");
    };
    EXPECT_TRUE(made());
    EXPECT_FALSE(made());
    settings.orbit.azimuth += 10;
    settings.exposure = 1;
    surroundings.exposure = 1;
    EXPECT_FALSE(made());
    surroundings.sky.sun_height += 1;
    EXPECT_TRUE(made());
    EXPECT_FALSE(made());
}

TEST_F(SurroundingsTest, a_scene_without_a_sky_has_nothing_of_it) {
    const Loaded loaded(scene_at(*scene_named("plain"), 0));
    Graph graph;
    build_frame(graph, loaded.inputs(), settings_for(loaded.scene));
    for (const Resource& resource : graph.resources()) {
        EXPECT_FALSE(resource.name.starts_with("surroundings") || resource.name == "sky" ||
                     resource.name == "reflectance")
            << resource.name;
    }
    for (const PassRecord& pass : graph.passes()) {
        EXPECT_FALSE(pass.shader.starts_with("surroundings")) << pass.name;
        if (pass.name == "lighting") {
            // The shader's branches for it are compiled away.
            EXPECT_EQ(pass.constants.back(), 0U);
        }
    }
    const auto said = graph.withheld();
    EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const Withheld& it) {
        return it.name == "surroundings levels" &&
               it.reason == "the gradient and soft boxes need none";
    }));
}

} // namespace
} // namespace preview
