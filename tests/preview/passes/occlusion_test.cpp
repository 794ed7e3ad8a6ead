// Ambient occlusion on a device: against its twin in double, and against rays.
#include "preview/passes/occlusion.h"
#include "preview/reference/occlusion.h"
#include "preview/scene/gpu_scene.h"
#include "tests/preview/frame/frame_fixture.h"
#include "tests/preview/passes/visibility_fixture.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>

namespace preview {
namespace {

constexpr glm::dvec3 ball_centre{0.1, 0.25, 0};
constexpr double ball_radius = 0.25, wall_z = -0.4, occlusion_radius = 0.3;

/// A ball on a floor before a wall.
Scene corner_scene() {
    Scene scene;
    scene.meshes = {plane(), sphere(24, 48)};
    scene.materials.emplace_back();
    const glm::mat4 unit(1);
    Object floor, wall, ball;
    floor.transform = glm::scale(unit, glm::vec3(3));
    wall.transform = glm::rotate(glm::translate(unit, {0, 0, static_cast<float>(wall_z)}),
                                 glm::radians(90.0F), {1, 0, 0}) *
                     glm::scale(unit, glm::vec3(3));
    ball.mesh = 1;
    ball.transform = glm::scale(glm::translate(unit, glm::vec3(ball_centre)),
                                glm::vec3(static_cast<float>(ball_radius)));
    scene.objects = {floor, wall, ball};
    scene.orbit.target = {0, 0.2F, -0.1F};
    scene.orbit.elevation = 25;
    scene.orbit.azimuth = 20;
    scene.orbit.distance = 2.2F;
    return scene;
}

class OcclusionTest : public GpuTest {
  protected:
    struct Pictures {
        reference::SeenSurfaces seen;
        std::vector<float> occlusion;
    };
    static Pictures render(const Scene& scene, const OcclusionInputs& inputs) {
        const GpuScene gpu_scene(device(), scene);
        Graph graph;
        Pictures out;
        out.seen.view = view_block(scene.orbit, aspect);
        out.seen.width = static_cast<int>(size.width);
        out.seen.height = static_cast<int>(size.height);
        const SceneHandles handles = import_scene(graph, scene, gpu_scene, out.seen.view);
        const GBuffer surfaces =
            add_gbuffer(graph, handles, size, all_draws(scene, gpu_scene.geometry));
        const ImageHandle occlusion = add_occlusion(graph, handles, surfaces, inputs);
        for (const ImageHandle image : {surfaces.depth, surfaces.normal, occlusion}) {
            graph.present(image);
        }
        Executor executor(device());
        executor.render(graph);
        out.seen.depth = as<float>(executor.read_image(surfaces.depth));
        for (const auto& bits :
             as<std::array<std::uint16_t, 2>>(executor.read_image(surfaces.normal))) {
            out.seen.normal.emplace_back(decoded(bits));
        }
        out.occlusion = as<float>(executor.read_image(occlusion));
        return out;
    }
};

TEST_F(OcclusionTest, is_its_twin_but_where_rounding_moves_a_point_to_the_next_texel) {
    for (const reference::OcclusionModel& model :
         {reference::OcclusionModel{1, occlusion_radius, 16},
          {0.5, 0.6, 7},
          {1, occlusion_radius, 16, 1},
          {0.8, 0.4, 9, 4},
          {1, 0.5, 12, 3}}) {
        const Pictures found = render(corner_scene(), {static_cast<float>(model.strength),
                                                       static_cast<float>(model.radius),
                                                       static_cast<std::uint32_t>(model.samples),
                                                       static_cast<std::uint32_t>(model.cell)});
        const auto expected = reference::occlusion(found.seen, model);
        std::size_t others = 0;
        double most = 0;
        for (std::size_t at = 0; at < expected.size(); ++at) {
            const double difference =
                std::abs(static_cast<double>(found.occlusion[at]) - expected[at]);
            others += difference > 1e-3 ? 1 : 0;
            most = std::max(most, difference);
        }
        EXPECT_LT(others, expected.size() / 50) << model.cell;
        EXPECT_LT(most, 2.0 / model.samples) << model.cell;
    }
}

TEST_F(OcclusionTest, is_nearer_to_what_every_pixel_sees_the_more_pixels_see_for_themselves) {
    double before = 0;
    for (const OcclusionResolution& row : occlusion_resolutions()) {
        const Pictures found =
            render(corner_scene(), {1, static_cast<float>(occlusion_radius), 64, row.side});
        const std::vector<double> wanted =
            reference::occlusion_of_every_pixel(found.seen, {1, occlusion_radius, 512});
        double apart = 0;
        for (std::size_t at = 0; at < wanted.size(); ++at) {
            apart += std::abs(static_cast<double>(found.occlusion[at]) - wanted[at]);
        }
        apart /= static_cast<double>(wanted.size());
        EXPECT_GT(apart, before) << row.name;
        EXPECT_LT(apart, 0.03) << row.name;
        before = apart;
    }
}

/// Distance along a ray from the floor to the ball or the wall, the nearer.
std::optional<double> hit(glm::dvec3 from, glm::dvec3 direction) {
    std::optional<double> nearest;
    const auto take = [&](double distance) {
        if (distance > 0 && (!nearest || distance < *nearest)) {
            nearest = distance;
        }
    };
    take((wall_z - from.z) / direction.z);
    const glm::dvec3 away = from - ball_centre;
    const double b = glm::dot(away, direction);
    const double root = b * b - glm::dot(away, away) + ball_radius * ball_radius;
    if (root > 0 && -b - std::sqrt(root) > 0) {
        take(-b - std::sqrt(root));
    }
    return nearest;
}

TEST_F(OcclusionTest, is_what_rays_find_and_leaves_open_planes_alone) {
    const Pictures found = render(corner_scene(), {1, static_cast<float>(occlusion_radius), 32});
    const glm::dvec3 eye(found.seen.view.position_near);
    const std::vector<double> unblurred =
        reference::occlusion_of_every_pixel(found.seen, {1, occlusion_radius, 256});
    double sum = 0, most = 0, mean = 0, mean_unblurred = 0;
    int count = 0, open = 0;
    for (int y = 2; y + 2 < found.seen.height; ++y) {
        for (int x = 2; x + 2 < found.seen.width; ++x) {
            glm::dvec3 at = eye + found.seen.position(x, y);
            const bool is_floor = std::abs(at.y) < 1e-4;
            at.y = 0;
            if (!is_floor || std::abs(at.x) > 2 || at.z > 2) {
                continue;
            }
            const double expected = reference::ray_cast_occlusion(
                {0, 1, 0}, occlusion_radius, 256,
                [&](const glm::dvec3& direction) { return hit(at, direction); });
            const double difference =
                static_cast<double>(found.occlusion[found.seen.index(x, y)]) - expected;
            if (expected == 1) {
                EXPECT_GT(difference, -0.08) << x << ',' << y; // blurred over five pixels
                ++open;
                continue;
            }
            sum += difference;
            mean_unblurred += std::abs(unblurred[found.seen.index(x, y)] - expected);
            mean += std::abs(difference);
            most = std::max(most, std::abs(difference));
            ++count;
        }
    }
    EXPECT_NEAR(sum / count, 0, 0.02);
    EXPECT_GT(count, 400);
    EXPECT_GT(open, 200);
    EXPECT_LT(mean / count, 0.06); // pixels are 3 cm, a tenth of the radius
    EXPECT_LT(mean_unblurred / count, 0.06);
    EXPECT_LT(most, 0.5); // where the ball hides from the camera what it stands on
}

TEST_F(FrameTest, ambient_occlusion_darkens_corners_and_costs_nothing_where_it_is_not_wanted) {
    Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    settings.effects.clear();
    settings.bloom = bloom_named("none");
    Executor executor(device());
    const Rendered whole = render_frame(executor, loaded.inputs(), settings);
    EXPECT_TRUE(kept(whole, "ambient occlusion")) << whole.explanation;
    const std::size_t steps = executor.plan().steps.size();

    const auto without = [&](std::string_view reason) {
        const Rendered rendered = render_frame(executor, loaded.inputs(), settings);
        EXPECT_EQ(executor.plan().steps.size(), steps - 4) << reason;
        EXPECT_NE(rendered.explanation.find(reason), std::string::npos) << rendered.explanation;
        return rendered.rgba;
    };
    settings.occlusion.strength = 0;
    const auto plain = without("its strength is 0");
    settings.occlusion.strength = 1;
    loaded.scene.occlusion = 0;
    EXPECT_EQ(without("the scene does not ask for it"), plain);
    loaded.scene.occlusion = 1;
    loaded.scene.environment = {};
    without("there is no light of surroundings");

    long darker = 0, brighter = 0;
    for (std::size_t at = 0; at < plain.size(); ++at) {
        darker += whole.rgba[at] + 2 < plain[at] ? 1 : 0;
        brighter += whole.rgba[at] > plain[at] + 2 ? 1 : 0;
    }
    EXPECT_GT(darker, 500);
    EXPECT_EQ(brighter, 0);
}

} // namespace
} // namespace preview
