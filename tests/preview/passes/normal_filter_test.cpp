// Specular antialiasing: what both rasterisers say of curved surfaces, and that highlights hold
// still while the camera moves.
#include "preview/frame/frame.h"
#include "preview/reference/ggx.h"
#include "tests/preview/passes/visibility_fixture.h"
#include "tests/support/thorough.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace preview {
namespace {

/// The normal of the unit ball about the origin that a pixel shows.
std::optional<glm::dvec3> ball_normal(const ViewBlock& view, double x, double y) {
    const glm::dvec3 ray = glm::normalize(
        glm::dvec3(view.forward) + ((x + 0.5) / size.width * 2 - 1) * glm::dvec3(view.right) +
        ((y + 0.5) / size.height * 2 - 1) * glm::dvec3(view.up));
    const glm::dvec3 eye(view.position_near);
    const double b = glm::dot(eye, ray);
    const double root = b * b - glm::dot(eye, eye) + 1;
    if (root < 0.4) { // near the outline facets show
        return {};
    }
    return glm::normalize(eye - ray * (b + std::sqrt(root)));
}

TEST_F(VisibilityTest, both_rasterisers_widen_highlights_by_how_a_ball_turns_within_a_pixel) {
    Scene scene;
    scene.meshes.push_back(sphere(48, 96));
    scene.materials.emplace_back();
    scene.objects.emplace_back();
    scene.orbit.distance = 7;
    const ViewBlock view = view_block(scene.orbit, aspect);
    const GpuScene gpu_scene(device(), scene);
    const auto draws = all_draws(scene, gpu_scene.geometry);
    for (const bool by_compute : {false, true}) {
        const auto found =
            render(scene, gpu_scene, view, size, [&](Graph& graph, const auto& handles, Size s) {
                return by_compute ? add_visibility(graph, handles, s, draws, {}, true)
                                  : add_gbuffer(graph, handles, s, draws, true);
            });
        int compared = 0;
        for (std::uint32_t y = 0; y + 1 < size.height; ++y) {
            for (std::uint32_t x = 0; x + 1 < size.width; ++x) {
                const auto here = ball_normal(view, x, y), right = ball_normal(view, x + 1, y),
                           below = ball_normal(view, x, y + 1);
                if (!here || !right || !below) {
                    continue;
                }
                const double expected =
                    reference::filtered_roughness(0, *right - *here, *below - *here);
                const std::uint32_t word = found.material[std::size_t{y} * size.width + x];
                ASSERT_EQ(word & 0xffffffU, 1U);
                // alpha^2 is roughness^4, and eight bits hold its root.
                const double roughness =
                    std::sqrt(std::sqrt(0.18) * static_cast<double>(word >> 24U) / 255);
                // A GPU takes differences over pairs of pixels, ours over the next one.
                EXPECT_NEAR(roughness, expected, 0.1 * expected) << x << ',' << y;
                ++compared;
            }
        }
        EXPECT_GT(compared, 100);
    }
}

/// The largest and the smallest value of the scene's brightest texel over a pan of one degree.
struct Brightest {
    float least = std::numeric_limits<float>::max(), most = 0;
};

class PanTest : public GpuTest {
  protected:
    static Brightest over_a_pan(const Scene& scene, FrameSettings settings, int steps = 10) {
        const GpuScene gpu_scene(device(), scene);
        FrameInputs inputs;
        inputs.scene = &scene;
        inputs.gpu_scene = &gpu_scene;
        settings.only_maximum = true;
        settings.orbit = scene.orbit;
        Executor executor(device());
        Brightest out;
        for (int step = 0; step <= steps; ++step) {
            Graph graph;
            const FrameHandles handles = build_frame(graph, inputs, settings);
            executor.render(graph);
            const float found = as<float>(executor.read_buffer(handles.hdr_maximum)).front();
            out = {std::min(out.least, found), std::max(out.most, found)};
            settings.orbit.azimuth += 1.0F / static_cast<float>(steps);
        }
        return out;
    }
};

TEST_F(PanTest, the_brightest_texel_of_the_sample_holds_within_a_fifth_over_a_slow_pan) {
    FrameSettings settings;
    settings.output = {640, 360};
    const Brightest found =
        over_a_pan(scene_at(*scene_named("sample"), 0), settings, support::is_thorough() ? 10 : 5);
    EXPECT_GT(found.least, 100);
    EXPECT_LT(found.most - found.least, 0.2F * found.most) << found.least << " to " << found.most;
}

TEST_F(PanTest, the_brightest_highlight_of_the_studio_flickers_less_over_a_slow_pan) {
    Scene scene = scene_at(*scene_named("studio"), 0);
    for (Material& material : scene.materials) {
        material.emission = glm::vec3(0); // what shines by itself is no highlight
    }
    FrameSettings settings;
    settings.output = {160, 90};
    settings.shadow_size = 256;
    const auto change = [&](bool filters) {
        settings.without.set(Effect::specular_aa, !filters);
        const Brightest found = over_a_pan(scene, settings);
        return found.most / found.least;
    };
    EXPECT_LT(change(true), 1.5F);
    EXPECT_GT(change(false), 2);
}

} // namespace
} // namespace preview
