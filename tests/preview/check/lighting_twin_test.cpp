// The lighting pass against its twin in double: every kind of light and of surroundings, and that
// the twin finds what differs.
#include "preview/check/twins.h"
#include "preview/frame/frame.h"
#include "preview/reference/area_light_model.h"
#include "preview/reference/gradient.h"
#include "preview/scene/builtin.h"
#include "tests/preview/graph/gpu_test.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace preview {
namespace {

/// A floor, a box on it and balls from a mirror to chalk.
Scene things() {
    SceneBuilder build;
    const std::uint32_t floor = build.mesh(plane()), ball = build.mesh(sphere(24, 32)),
                        block = build.mesh(box(glm::vec3(0.4F), 0));
    build.place(floor, build.material({.albedo = glm::vec3(0.6F, 0.5F, 0.4F), .roughness = 0.4F}),
                at({0, 0, 0}, glm::vec3(6)));
    build.place(block, build.material({.albedo = glm::vec3(0.1F, 0.5F, 0.9F), .roughness = 0.8F}),
                at({-1.6F, 0.4F, 0.2F}));
    for (int i = 0; i < 4; ++i) {
        Material material{.albedo = glm::vec3(0.9F, 0.6F, 0.3F),
                          .roughness = 0.05F + 0.3F * static_cast<float>(i),
                          .metalness = i % 2 == 0 ? 1.0F : 0.0F};
        material.emission = i == 3 ? glm::vec3(0.1F, 0.2F, 0.05F) : glm::vec3(0);
        build.place(ball, build.material(material),
                    at({-0.6F + 0.8F * static_cast<float>(i), 0.35F, 0.5F}, glm::vec3(0.35F)));
    }
    Scene& scene = build.scene;
    scene.environment.zenith = {0.1F, 0.15F, 0.3F};
    scene.environment.horizon = glm::vec3(0.2F);
    scene.environment.ground = {0.05F, 0.04F, 0.03F};
    scene.environment.soft_box_count = 2;
    scene.environment.soft_boxes[0] = {glm::normalize(glm::vec3(1, 1, 1)), 40, glm::vec3(6)};
    scene.environment.soft_boxes[1] = {{-1, 0, 0}, 150, {0, 3, 9}};
    scene.orbit = {{0, 0.3F, 0}, 5, 15, 22, 45, 0.1F};
    scene.occlusion = 1;
    return scene;
}

PointLight light_at(glm::vec3 place) {
    PointLight light;
    light.position = place;
    light.intensity = {9, 8, 7};
    light.casts_shadow = true;
    light.shadow_angle = PointLight::all_round;
    return light;
}

PointLight area_at(glm::vec3 place, PointLight::Shape shape, glm::vec3 extent, float thickness) {
    PointLight light = light_at(place);
    light.shape = shape;
    light.extent = extent;
    light.thickness = thickness;
    return light;
}

PointLight spot() {
    PointLight light = light_at({1, 3, 2});
    light.axis = glm::normalize(glm::vec3(-1, -3, -2));
    light.inner_angle = 8;
    light.outer_angle = 25;
    light.shadow_angle = 60;
    return light;
}

PointLight sun() {
    PointLight light = light_at({2, 3, 1});
    light.is_sun = true;
    light.intensity = glm::vec3(2);
    return light;
}

PointLight with_reach() {
    PointLight light = light_at({0.5F, 1.5F, 1});
    light.reach = 2.5F;
    return light;
}

struct LightCase {
    const char* name;
    std::vector<PointLight> lights;
};

std::vector<LightCase> light_cases() {
    using Shape = PointLight::Shape;
    PointLight negative = light_at({-1, 2, 2});
    negative.intensity = glm::vec3(-3);
    return {{"none", {}},
            {"all round", {light_at({0.3F, 2, 1.2F})}},
            {"spot", {spot()}},
            {"sun", {sun()}},
            {"reach", {with_reach()}},
            {"negative", {negative, light_at({1, 2, 2})}},
            {"ball", {area_at({0, 1.5F, 1}, Shape::point, {}, 0.3F)}},
            {"rod", {area_at({0, 1.2F, 0.5F}, Shape::rod, {0.8F, 0.2F, 0}, 0.03F)}},
            {"rod through the floor", {area_at({0, 0.2F, 1.5F}, Shape::rod, {0, 0.7F, 0.1F}, 0)}},
            {"small rod far away", {area_at({1, 5, 2}, Shape::rod, {0.01F, 0, 0.005F}, 0.001F)}},
            {"ring", {area_at({0.2F, 1.4F, 0.3F}, Shape::ring, {0.1F, 0.5F, 0.2F}, 0.02F)}},
            {"all", {spot(), sun(), with_reach(), light_at({0.3F, 2, 1.2F})}}};
}

class LightingTwinTest : public GpuTest {
  protected:
    struct Seen {
        Graph graph;
        std::vector<Observed> observed;
    };

    static Situation situation_of(const Scene& scene) {
        Shown shown;
        shown.name = "a test";
        shown.scene = scene;
        Situation out;
        out.settings.output = {64, 36};
        out.settings.shadow_size = 128;
        out.settings.orbit = scene.orbit;
        out.settings.force_all = true;
        out.settings.format = Format::rgba32f;
        out.lights = scene.lights;
        out.surroundings = scene.surroundings;
        out.shown = std::make_shared<const Shown>(std::move(shown));
        return out;
    }

    static Seen see(const Situation& situation) {
        // One for all tests: pipelines take longer to make than such pictures.
        static Executor executor(device());
        const GpuShown on_gpu(device(), situation.shown);
        FrameInputs inputs = on_gpu.inputs();
        inputs.lights = &situation.lights;
        inputs.surroundings = &situation.surroundings;
        Seen out;
        (void)build_frame(out.graph, inputs, situation.settings);
        out.graph = with_lighting_apart(out.graph);
        out.observed = observe(executor, out.graph);
        executor.wait();
        return out;
    }

    static TwinFigure figure_of(const Situation& situation, const Seen& seen) {
        for (const TwinFigure& one : twin_figures(situation, seen.graph, seen.observed)) {
            if (one.pass == "lighting") {
                return one;
            }
        }
        ADD_FAILURE() << "the lighting pass has no twin";
        return {};
    }

    static void expect_near(const Situation& situation, const std::string& what) {
        const TwinFigure figure = figure_of(situation, see(situation));
        EXPECT_TRUE(figure.is_near()) << what << ": " << figure.largest << ' ' << figure.beyond;
        EXPECT_TRUE(figure.keeps_light()) << what << ": " << figure.drift;
    }
};

TEST_F(LightingTwinTest, every_kind_of_light_is_its_twins_with_its_shadow) {
    const Scene scene = things();
    for (const LightCase& row : light_cases()) {
        Situation situation = situation_of(scene);
        situation.lights = row.lights;
        expect_near(situation, row.name);
    }
}

// It has a direction in place of the position that a ball would have.
TEST_F(LightingTwinTest, a_suns_thickness_changes_nothing) {
    Situation situation = situation_of(things());
    situation.lights = {sun()};
    const Seen thin = see(situation);
    situation.lights[0].thickness = 0.2F;
    const Seen thick = see(situation);
    EXPECT_EQ(left_by(thin.observed, "lighting")->values,
              left_by(thick.observed, "lighting")->values);
    expect_near(situation, "a thick sun");
}

TEST_F(LightingTwinTest, every_filter_of_shadows_is_its_twins) {
    Situation situation = situation_of(things());
    situation.lights = light_cases().back().lights;
    for (const ShadowFilter& filter : shadow_filters()) {
        situation.settings.shadow_filter = &filter;
        expect_near(situation, std::string(filter.name));
    }
}

/// Noise over all directions with a bright texel.
ShownPicture all_directions() {
    ShownPicture out;
    out.size = {48, 24};
    std::mt19937 random(1);
    for (std::uint32_t i = 0; i < 4 * out.size.width * out.size.height; ++i) {
        out.rgba.push_back(static_cast<float>(random() % 1000) / 500);
    }
    out.rgba[4 * 300] = 90;
    return out;
}

TEST_F(LightingTwinTest, every_kind_of_surroundings_is_its_twins_on_surfaces_and_behind_them) {
    const Scene scene = things();
    for (const SurroundingsInfo& info : surroundings_kinds()) {
        for (const bool has_occlusion : {true, false}) {
            Situation situation = situation_of(scene);
            auto shown = std::make_shared<Shown>(*situation.shown);
            shown->surroundings = all_directions();
            situation.shown = std::move(shown);
            situation.settings.orbit.elevation = 2;
            situation.settings.without.set(Effect::occlusion, !has_occlusion);
            Surroundings& surroundings = situation.surroundings;
            surroundings.kind = info.kind;
            surroundings.exposure = 0.7F;
            surroundings.rotation = 40;
            surroundings.sky.sun_azimuth = situation.settings.orbit.azimuth;
            surroundings.sky.sun_height = 12;
            expect_near(situation, std::string(info.name));
        }
    }
}

TEST_F(LightingTwinTest, every_built_in_scene_is_its_twins_by_both_rasterisers) {
    for (const SceneInfo& info : scenes()) {
        Situation situation = situation_of(scene_at(info, 0));
        for (const Raster raster : {Raster::hardware, Raster::compute}) {
            if (raster == Raster::compute && !device().has_int64_atomics()) {
                continue;
            }
            situation.settings.raster = raster;
            expect_near(situation, std::string(info.name));
        }
    }
}

// A highlight of roughness 0.045 is two thousandths of a radian wide.
TEST_F(LightingTwinTest, highlights_of_mirrors_keep_their_digits) {
    Scene scene = scene_at(*scene_named("studio"), 0);
    for (Material& material : scene.materials) {
        material = {.albedo = glm::vec3(1), .roughness = 0, .metalness = 1};
    }
    expect_near(situation_of(scene), "mirrors");
}

TEST_F(LightingTwinTest, what_see_through_surfaces_are_drawn_over_is_held_to_the_twin_too) {
    Scene scene = things();
    scene.lights = {light_at({0.3F, 2, 1.2F})};
    scene.materials.front().detail.is_blended = true;
    scene.materials.front().detail.coverage = 0.5F;
    const Situation situation = situation_of(scene);
    Seen seen = see(situation);
    EXPECT_EQ(left_by(seen.observed, "lighting"), nullptr);
    const TwinFigure figure = figure_of(situation, seen);
    EXPECT_TRUE(figure.is_near()) << figure.largest << ' ' << figure.beyond;
    for (Observed& one : seen.observed) {
        if (one.pass == "copy") {
            one.values[4 * (64 * 20 + 30)] += 0.1F;
        }
    }
    EXPECT_EQ(figure_of(situation, seen).beyond, figure.beyond + 1);
}

TEST_F(LightingTwinTest, without_any_light_surfaces_give_their_own) {
    Situation situation = situation_of(things());
    situation.settings.without.set(Effect::environment, true);
    expect_near(situation, "dark");
}

TEST_F(LightingTwinTest, an_error_of_one_texel_or_a_loss_of_all_light_is_found) {
    Scene scene = things();
    scene.lights = {sun(), light_at({0.3F, 2, 1.2F})};
    const Situation situation = situation_of(scene);
    const Seen seen = see(situation);
    const TwinFigure plain = figure_of(situation, seen);
    const auto changed = [&](auto change) {
        Seen out = seen;
        for (Observed& one : out.observed) {
            if (one.pass == "lighting") {
                change(one.values);
            }
        }
        return figure_of(situation, out);
    };
    const TwinFigure brighter =
        changed([](std::vector<float>& values) { values[4 * (64 * 20 + 30) + 1] *= 1.003F; });
    EXPECT_EQ(brighter.beyond, plain.beyond + 1);
    EXPECT_FALSE(changed([](std::vector<float>& values) { values[5] = NAN; }).keeps_light());
    // As a driver's that cuts off where it should round.
    const TwinFigure cut = changed([](std::vector<float>& values) {
        for (float& value : values) {
            value *= 1 - 3.5e-4F;
        }
    });
    EXPECT_TRUE(cut.is_near());
    EXPECT_FALSE(cut.keeps_light());
}

TEST_F(LightingTwinTest, all_that_the_pass_reads_counts) {
    Scene scene = things();
    scene.lights = {sun(), light_at({0.3F, 2, 1.2F})};
    Situation situation = situation_of(scene);
    situation.surroundings.kind = SurroundingsKind::sky;
    const Seen seen = see(situation);
    std::size_t images = 0;
    const PassRecord& pass = seen.graph.passes()[left_by(seen.observed, "lighting")->order];
    for (std::size_t i = 0; i < seen.observed.size(); ++i) {
        const bool is_read = std::any_of(pass.uses.begin(), pass.uses.end(), [&](const Use& use) {
            return !use.writes && use.version == seen.observed[i].version;
        });
        if (!is_read) {
            continue;
        }
        ++images;
        Seen other = seen;
        for (float& value : other.observed[i].values) {
            value = 0.9F * value + 0.01F;
        }
        for (std::uint32_t& word : other.observed[i].words) {
            word = word > 1 ? word - 1 : word;
        }
        EXPECT_FALSE(figure_of(situation, other).is_near()) << seen.observed[i].name;
    }
    // Depth, normals, materials, shadow maps, occlusion, irradiance, levels, reflectance.
    EXPECT_EQ(images, 8U);
    situation.surroundings.exposure = 0.01F;
    EXPECT_FALSE(figure_of(situation, seen).is_near());
}

TEST(LightingReference, the_irradiance_of_a_line_is_the_sum_over_its_points) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.1, 1, -0.2));
    struct Line {
        glm::dvec3 a, b;
    };
    for (const auto& [a, b] :
         {Line{{-1, 1, 0}, {1, 1.5, 0.3}}, Line{{-1, -0.4, 0.2}, {1, 0.8, 0.1}},
          Line{{0.3, 0.9, 0.2}, {0.2, -2, 0}}, Line{{-1, -1, 0}, {1, -0.5, 0}},
          Line{{0, 2, 0}, {0, 2.0001, 0}}}) {
        constexpr int points = 200000;
        double sum = 0;
        for (int i = 0; i < points; ++i) {
            const glm::dvec3 place = a + (b - a) * ((i + 0.5) / points);
            sum += std::max(glm::dot(normal, place), 0.0) / std::pow(glm::length(place), 3);
        }
        EXPECT_NEAR(reference::line_irradiance(normal, a, b), sum / points, 1e-6 * sum / points);
    }
}

TEST(LightingReference, the_gradient_with_its_soft_boxes_is_that_of_the_scene) {
    const Environment environment = things().environment;
    std::mt19937 random(3);
    std::normal_distribution<double> gaussian;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 direction =
            glm::normalize(glm::dvec3(gaussian(random), gaussian(random), gaussian(random)));
        const float roughness = static_cast<float>(i) / 199;
        const glm::vec3 seen = radiance(environment, glm::vec3(direction), roughness),
                        around = irradiance(environment, glm::vec3(direction));
        const lutlib::RgbD twin = reference::radiance(environment, direction,
                                                      static_cast<double>(roughness)),
                           twin_around = reference::irradiance(environment, direction);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto at = static_cast<int>(c);
            EXPECT_NEAR(seen[at], twin[c], 1e-4 * twin[c]);
            EXPECT_NEAR(around[at], twin_around[c], 1e-4 * twin_around[c]);
        }
    }
}

} // namespace
} // namespace preview
