// The renderer under extreme input: what `lutpreview check` holds it to, on small pictures, and
// that a fault is found where there is one.
#include "preview/check/check.h"
#include "preview/effects/effect.h"
#include "preview/frame/frame.h"
#include "preview/graph/interpose.h"
#include "preview/passes/copy.h"
#include "preview/passes/plant.h"
#include "preview/passes/resolve.h"
#include "tests/preview/graph/gpu_test.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <set>

namespace preview {
namespace {

/// As usual, and small.
Situation situation_of(Shown shown) {
    Situation out;
    out.settings.output = {48, 27};
    out.settings.shadow_size = 64;
    if (shown.scene) {
        out.settings.orbit = shown.scene->orbit;
        out.lights = shown.scene->lights;
        out.surroundings = shown.scene->surroundings;
    }
    out.shown = std::make_shared<const Shown>(std::move(shown));
    return out;
}

Situation situation_of(const Scene& scene) {
    Shown shown;
    shown.name = "a test";
    shown.scene = scene;
    return situation_of(std::move(shown));
}

/// A picture with a slope, a bright texel and a dark one.
Shown slope() {
    Shown shown;
    shown.name = "slope";
    ShownPicture picture;
    picture.size = {48, 27};
    for (std::uint32_t i = 0; i < 48U * 27; ++i) {
        const auto x = static_cast<float>(i % 48), y = static_cast<float>(i / 48);
        picture.rgba.insert(picture.rgba.end(), {x / 48, y / 27, 0.25F, 1});
    }
    picture.rgba[400] = 900;
    shown.picture = std::move(picture);
    return shown;
}

class CheckTest : public GpuTest {
  protected:
    static void expect_no_fault(const std::vector<std::string>& faults, const std::string& name) {
        for (const std::string& fault : faults) {
            ADD_FAILURE() << name << ": " << fault;
        }
    }
    static void expect_all_hold(const CheckReport& report) {
        for (const ExtremeResult& one : report.extremes) {
            expect_no_fault(one.faults, one.name);
            EXPECT_TRUE(one.skipped.empty() || one.name == "drawn by compute shaders")
                << one.name << ": " << one.skipped;
        }
        for (const PlantResult& one : report.plants) {
            expect_no_fault(one.faults, one.value + " in " + one.name);
        }
        EXPECT_FALSE(report.extremes.empty());
    }
    static CheckReport checked(Situation situation) {
        Checker checker(device(), std::move(situation));
        return run_check(checker, [](const std::string&) {});
    }
};

TEST_F(CheckTest, a_scene_with_every_kind_of_light_bears_extreme_input) {
    const CheckReport report = checked(situation_of(scene_at(*scene_named("night"), 0)));
    expect_all_hold(report);
    EXPECT_GT(report.plants.size(), 12U);
    EXPECT_GT(report.nudges.size(), 10U);
}

TEST_F(CheckTest, a_picture_bears_extreme_input) {
    const CheckReport report = checked(situation_of(slope()));
    expect_all_hold(report);
    EXPECT_EQ(report.plants.size(), 6U) << "the picture is all that the resolve reads";
    for (const ExtremeResult& one : report.extremes) {
        EXPECT_GE(one.twins.size(), 4U) << one.name;
    }
}

/// Things and lights of random sizes, places and materials, many of them at an end of what they may
/// be: no size, no colour, mirrors, lights on surfaces and on each other.
Scene stiff_scene(unsigned seed) {
    std::mt19937 random(seed);
    const auto one_of = [&](std::initializer_list<float> values) {
        return values.begin()[random() % values.size()];
    };
    const auto place = [&] {
        return glm::vec3(one_of({-1, 0, 0, 1e-7F, 2}), one_of({0, 0, 1, 1e4F}),
                         one_of({-1, 0, 1e-30F, 1}));
    };
    Scene scene;
    scene.meshes = {sphere(6, 8), plane(), box(glm::vec3(0.5F), 0)};
    for (int i = 0; i < 6; ++i) {
        Material material;
        material.roughness = one_of({0, 1e-6F, 0.045F, 1});
        material.metalness = one_of({0, 1});
        material.albedo = glm::vec3(one_of({0, 1e-8F, 1}), one_of({0, 0.5F}), one_of({0, 1}));
        material.emission = glm::vec3(one_of({0, 0, 65504, 1e20F}));
        scene.materials.push_back(material);
        Object object;
        object.mesh = static_cast<std::uint32_t>(random() % scene.meshes.size());
        object.material = static_cast<std::uint32_t>(random() % scene.materials.size());
        const float size = one_of({0, 1e-6F, 1, 1, 1e5F});
        object.transform = glm::mat4(size);
        object.transform[1] *= one_of({0, 1, -1});
        object.transform[3] = glm::vec4(place(), 1);
        scene.objects.push_back(object);
    }
    for (int i = 0; i < 4; ++i) {
        PointLight light;
        light.position = place();
        light.aim = one_of({0, 1}) > 0 ? light.position : place();
        light.intensity = glm::vec3(one_of({0, 1e-30F, 1, 65504, 1e20F}));
        light.casts_shadow = i % 2 == 0;
        light.shadow_angle = one_of({1, 90, 170, PointLight::all_round});
        light.outer_angle = one_of({180, 1, 0});
        light.is_sun = one_of({0, 0, 1}) > 0;
        light.thickness = one_of({0, 0, 1e-6F, 3});
        light.shape = i == 3 ? PointLight::Shape::ring : PointLight::Shape::point;
        light.extent = glm::vec3(0, one_of({0, 1}), 0);
        scene.lights.push_back(light);
    }
    scene.environment.zenith = glm::vec3(one_of({0, 1, 65504}));
    scene.occlusion = 1;
    return scene;
}

TEST_F(CheckTest, stiff_scenes_stay_finite_behind_the_resolve) {
    for (unsigned seed = 0; seed < 24; ++seed) {
        Checker checker(device(), situation_of(stiff_scene(seed)));
        const ExtremeResult result = checker.check(Extreme{.name = "as it is"});
        expect_no_fault(result.faults, "seed " + std::to_string(seed));
        EXPECT_EQ(result.skipped, "");
        EXPECT_GT(result.frame.passes.size(), 10U);
    }
}

TEST_F(CheckTest, what_is_not_finite_behind_the_resolve_is_found_with_its_pass) {
    const Shown shown = slope();
    const GpuPicture picture(device(), shown.picture->size, shown.picture->rgba, false);
    Graph graph;
    const ImageHandle source = graph.import("picture", picture.image, picture.image.desc());
    const Resolved resolved = add_resolve(graph, source, shown.picture->size, 1);
    graph.present(add_copy(graph, resolved.hdr, Format::rgba32f));
    Executor executor(device());
    const auto found_with = [&](ImageHandle image, float value) {
        const Graph changed = interposed(graph, image, [&](Graph& copy, ImageHandle from) {
            return add_plant(copy, from, {24, 13, value});
        });
        return finding_of(changed, observe(executor, changed));
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(finding_of(graph, observe(executor, graph)).after, 0U);
    EXPECT_EQ(found_with(source, nan).after, 0U) << "the resolve makes it finite";
    const FrameFinding behind = found_with(resolved.hdr, nan);
    EXPECT_EQ(behind.before, 0U);
    EXPECT_EQ(behind.after, 1U);
    EXPECT_EQ(behind.first_bad, "copy");
}

TEST_F(CheckTest, a_twin_that_differs_is_a_fault) {
    Situation situation = with_every_pass(situation_of(slope()));
    const GpuShown on_gpu(device(), situation.shown);
    Graph graph;
    (void)build_frame(graph, on_gpu.inputs(), situation.settings);
    Executor executor(device());
    std::vector<Observed> seen = observe(executor, graph);
    const auto beyond = [&](std::string_view pass) {
        for (const TwinFigure& twin : twin_figures(situation, graph, seen)) {
            if (twin.pass == pass) {
                return twin.beyond;
            }
        }
        return ~std::uint64_t{0};
    };
    EXPECT_EQ(beyond("hdr resolve"), 0U);
    EXPECT_EQ(beyond("finish"), 0U);
    for (Observed& one : seen) {
        if (one.pass == "hdr resolve" && one.channels == 4) {
            one.values[40] += 0.01F;
        }
        if (one.pass == "finish") {
            one.values[0] = std::numeric_limits<float>::quiet_NaN();
        }
    }
    EXPECT_EQ(beyond("hdr resolve"), 1U);
    EXPECT_GE(beyond("finish"), 1U);
    // The exposure that the twin is told of is another than the frame had.
    situation.settings.exposure = 0.01F;
    EXPECT_GT(beyond("hdr resolve"), 1000U);
}

TEST_F(CheckTest, every_effect_and_the_occlusion_have_a_twin_that_finds_what_differs) {
    Situation situation = with_every_pass(situation_of(scene_at(*scene_named("studio"), 0)));
    situation.settings.seconds = 1.37;
    const GpuShown on_gpu(device(), situation.shown);
    Executor executor(device());
    std::set<std::string> asked;
    const auto expect_found = [&](std::size_t channels) {
        Graph graph;
        (void)build_frame(graph, on_gpu.inputs(), situation.settings);
        const std::vector<Observed> seen = observe(executor, graph);
        for (const TwinFigure& twin : twin_figures(situation, graph, seen)) {
            EXPECT_TRUE(twin.is_near()) << twin.pass << ' ' << twin.largest << ' ' << twin.beyond;
            EXPECT_TRUE(twin.keeps_light()) << twin.pass << ' ' << twin.drift;
            std::vector<Observed> changed = seen;
            for (Observed& one : changed) {
                if (one.pass == twin.pass && (one.channels == 4 || one.channels == channels)) {
                    for (std::size_t at = 0; at < one.values.size(); at += 4) {
                        one.values[at] += 0.02F * (1 + one.values[at]);
                    }
                }
            }
            for (const TwinFigure& other : twin_figures(situation, graph, changed)) {
                EXPECT_FALSE(other.pass == twin.pass && other.is_near() && other.keeps_light())
                    << twin.pass;
            }
            asked.insert(twin.pass);
        }
    };
    for (const OcclusionResolution& row : occlusion_resolutions()) {
        situation.settings.occlusion.resolution = &row;
        expect_found(1);
    }
    for (const PostEffect* const effect : post_effects()) {
        EXPECT_TRUE(asked.contains(std::string(effect->name))) << effect->name;
    }
    EXPECT_TRUE(asked.contains("ambient occlusion enlarged"));
    EXPECT_TRUE(asked.contains("ambient occlusion blurred along y"));
}

TEST_F(CheckTest, a_step_in_a_shader_is_stiff) {
    // A glitch that changes 12 times a second, looked at within a microsecond of a change.
    Situation situation = situation_of(slope());
    put_use(situation.settings.effects, parse_use("glitch:strength=1,rate=10"));
    situation.settings.seconds = 0.1 - 0.5e-6;
    Checker checker(device(), situation);
    for (const Nudge& row : nudges(situation)) {
        const NudgeResult result = checker.check(row);
        if (row.name == "time") {
            ASSERT_FALSE(result.faults.empty());
            EXPECT_EQ(result.stiffest, "glitch");
            EXPECT_GT(result.gain, 1000);
        } else if (row.name == "exposure") {
            expect_no_fault(result.faults, row.name);
        }
    }
}

/// A built-in scene as it is usually checked, small: every other texel is beside an edge.
Situation small_with_antialiasing(std::string_view scene, Size size) {
    Shown shown;
    shown.name = scene;
    shown.scene = scene_at(*scene_named(scene), 0);
    Situation out = situation_of(std::move(shown));
    out.settings.output = size;
    out.settings.shadow_size = 256;
    set_usual(out.settings.effects, true);
    return out;
}

TEST_F(CheckTest, small_pictures_move_as_their_corners_are_rounded_and_no_more) {
    for (const auto& [scene, size] : {std::pair{"sample", Size{96, 54}}, {"studio", {64, 36}}}) {
        Checker checker(device(), small_with_antialiasing(scene, size));
        for (const Nudge& row : nudges(checker.situation())) {
            const NudgeResult result = checker.check(row);
            expect_no_fault(result.faults, std::string(scene) + ", " + row.name);
            EXPECT_LT(result.may_move, row.moves_geometry ? 0.02 : 0.013) << row.name;
        }
        // A twentieth of a texel is more than any rounding.
        const Nudge turn{.name = "a turn",
                         .change = [](Situation& situation,
                                      double) { situation.settings.orbit.azimuth += 0.05F; },
                         .moves_geometry = true};
        const NudgeResult result = checker.check(turn);
        EXPECT_GT(result.moved, result.may_move) << scene;
        EXPECT_FALSE(result.faults.empty()) << scene;
    }
}

/// Every power of two that floats hold, denormals too, and their negatives.
Shown powers_of_two() {
    Shown shown;
    shown.name = "powers of two";
    ShownPicture picture;
    picture.size = {23, 25};
    for (int i = 0; i < 23 * 25; ++i) {
        const float value = std::ldexp(i % 2 == 0 ? 1.0F : -1.0F, i / 2 - 149);
        picture.rgba.insert(picture.rgba.end(), {value, std::abs(value), 0.5F, 1});
    }
    shown.picture = std::move(picture);
    return shown;
}

TEST_F(CheckTest, pictures_of_every_half_and_of_nan_are_borne) {
    std::vector<Shown> pictures{powers_of_two()};
    const std::filesystem::path folder(EXTRA_DATA);
    for (const char* const name :
         {"BrightRingsNanInf.exr", "AllHalfValues.exr", "WideFloatRange.exr"}) {
        const std::string path = (folder / "images" / name).string();
        if (!folder.empty()) {
            ASSERT_TRUE(std::filesystem::exists(path)) << path;
            pictures.push_back(load_shown(path, 0));
        }
    }
    for (const Shown& shown : pictures) {
        Situation situation = situation_of(shown);
        situation.settings.output = shown.picture->size;
        Checker checker(device(), situation);
        Extreme row{.name = shown.name};
        row.is_not_finite = true;
        const ExtremeResult result = checker.check(row);
        expect_no_fault(result.faults, shown.name);
        EXPECT_EQ(result.frame.after, 0U);
        EXPECT_GE(result.twins.size(), 4U);
    }
}

} // namespace
} // namespace preview
