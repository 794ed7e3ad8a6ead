// Surfaces that are lit as they are drawn: see-through ones over the others, and the forward path
// beside the deferred one.
#include "preview/cli/headless.h"
#include "preview/frame/frame.h"
#include "preview/scene/builtin.h"
#include "preview/scene/gpu_scene.h"
#include "tests/preview/graph/gpu_test.h"
#include "tests/support/thorough.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace preview {
namespace {

class ForwardTest : public GpuTest {
  protected:
    Rendered render(const Scene& scene, Raster raster = Raster::hardware, Size size = {48, 32},
                    bool has_shadows = true) {
        const GpuScene gpu_scene(device(), scene);
        FrameInputs inputs;
        inputs.scene = &scene;
        inputs.gpu_scene = &gpu_scene;
        FrameSettings settings;
        settings.output = size;
        settings.orbit = scene.orbit;
        settings.raster = raster;
        settings.bloom = bloom_named("none");
        settings.tonemap = tonemap_named("none");
        settings.shadow_size = 128;
        settings.keep_hdr = true;
        settings.occlusion.strength = 0;
        settings.without.set(Effect::shadows, !has_shadows);
        return render_frame(executor_, inputs, settings);
    }

  private:
    Executor executor_{device()};
};

/// A pane that fills the picture at z, in front of those at smaller ones.
void add_pane(SceneBuilder& build, float z, glm::vec3 albedo, float coverage, bool is_blended) {
    Material material{.albedo = albedo, .roughness = 0.7F};
    material.detail.coverage = coverage;
    material.detail.is_blended = is_blended;
    build.place(build.mesh(plane()), build.material(material),
                turned(at({0, 0, z}, glm::vec3(20)), 90, {1, 0, 0}), false);
}

Scene lit_scene(SceneBuilder& build) {
    PointLight light;
    light.position = {1, 2, 6};
    light.intensity = {30, 24, 20};
    build.light(light);
    build.scene.environment.zenith = build.scene.environment.horizon = glm::vec3(0.2F);
    build.scene.orbit.distance = 8;
    return build.scene;
}

Scene panes(std::initializer_list<std::array<float, 3>> list, bool is_blended) {
    SceneBuilder build;
    // z, coverage, brightness
    for (const auto& [z, coverage, brightness] : list) {
        add_pane(build, z, glm::vec3(brightness, 0.5F * brightness, 0.1F), coverage,
                 is_blended && coverage < 1);
    }
    return lit_scene(build);
}

TEST_F(ForwardTest, a_see_through_surface_lies_over_what_is_behind_by_as_much_as_it_covers) {
    constexpr std::array<float, 3> wall{-2, 1, 0.8F}, near{1, 0.25F, 0.3F}, far{0, 0.6F, 0.6F};
    const auto behind = render(panes({wall}, true)).hdr;
    const auto middle = render(panes({far}, false)).hdr;
    const auto front = render(panes({near}, false)).hdr;
    for (const bool near_first : {false, true}) {
        const Scene scene =
            near_first ? panes({near, far, wall}, true) : panes({wall, far, near}, true);
        for (const Raster raster : {Raster::hardware, Raster::compute, Raster::forward}) {
            if (raster == Raster::compute && !device().has_int64_atomics()) {
                continue;
            }
            const auto found = render(scene, raster).hdr;
            ASSERT_EQ(found.size(), behind.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
                if (i % 4 == 3) {
                    continue;
                }
                const float mixed = 0.6F * middle[i] + 0.4F * behind[i];
                const float expected = 0.25F * front[i] + 0.75F * mixed;
                ASSERT_NEAR(found[i], expected, 0.002F * expected + 1e-4F) << i;
            }
        }
    }
}

TEST_F(ForwardTest, what_stands_in_front_hides_a_see_through_surface) {
    const auto alone = render(panes({{2, 1, 0.4F}}, true)).hdr;
    const auto with_hidden = render(panes({{2, 1, 0.4F}, {0, 0.5F, 0.9F}}, true)).hdr;
    ASSERT_EQ(alone.size(), with_hidden.size());
    for (std::size_t i = 0; i < alone.size(); ++i) {
        // The scene with a blended surface has a g-buffer of other formats.
        ASSERT_NEAR(alone[i], with_hidden[i], 0.003F * alone[i] + 1e-4F);
    }
}

// Drivers may cut off where a shader leaves the rounding to half floats to them: 3.5e-4 of all
// light.
TEST_F(ForwardTest, both_paths_round_light_and_cut_nothing_off) {
    const Scene scene = panes({{0, 1, 0.7F}}, false);
    const auto sum = [&](Raster raster) {
        double out = 0;
        for (const float value : render(scene, raster).hdr) {
            out += static_cast<double>(value);
        }
        return out;
    };
    const double deferred = sum(Raster::hardware);
    EXPECT_NEAR(sum(Raster::forward), deferred, 5e-5 * deferred);
}

TEST_F(ForwardTest, a_scene_without_see_through_surfaces_has_no_pass_for_them) {
    constexpr std::string_view reason = "nothing in the picture lets light through";
    const std::string without = render(panes({{0, 1, 0.5F}}, true)).explanation;
    EXPECT_NE(without.find(reason), std::string::npos) << without;
    const std::string with = render(panes({{0, 0.5F, 0.5F}}, true)).explanation;
    EXPECT_EQ(with.find(reason), std::string::npos) << with;
}

// Where textures turn normals, the deferred path finds the geometry's, by which shadows fall, from
// the depths of neighbours: at edges those are other surfaces.
TEST_F(ForwardTest, both_paths_give_one_picture_of_every_scene) {
    for (const SceneInfo& info : scenes()) {
        if (info.name != "studio" && info.name != "sample" && !support::is_thorough()) {
            continue;
        }
        const Scene scene = scene_at(info, 1);
        const bool has_shadows = !scene.has_detail();
        const auto deferred = render(scene, Raster::hardware, {160, 90}, has_shadows);
        const auto forward = render(scene, Raster::forward, {160, 90}, has_shadows);
        ASSERT_EQ(deferred.rgba.size(), forward.rgba.size());
        std::size_t differing = 0;
        for (std::size_t at = 0; at < forward.rgba.size(); at += 4) {
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                most = std::max(most,
                                std::abs(int{forward.rgba[at + c]} - int{deferred.rgba[at + c]}));
            }
            differing += most > 2 ? 1 : 0;
        }
        EXPECT_LT(static_cast<double>(differing) / static_cast<double>(forward.rgba.size() / 4),
                  0.005)
            << info.name << ": " << differing << " pixels";
    }
}

} // namespace
} // namespace preview
