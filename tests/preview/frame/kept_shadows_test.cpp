// Shadow maps from frame to frame: drawn when a light or a caster has moved and only then, and
// never to be told from maps that every frame draws anew.
#include "tests/preview/frame/frame_fixture.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <functional>

namespace preview {
namespace {

class KeptShadowsTest : public FrameTest {
  protected:
    struct Frame {
        int shadows_drawn = 0;
        std::vector<std::byte> output;
    };

    /// One frame of what was loaded, by this executor.
    static Frame frame(Executor& executor, const Loaded& loaded, const FrameSettings& settings) {
        Graph graph;
        const FrameHandles handles = build_frame(graph, loaded.inputs(), settings);
        executor.render(graph);
        Frame out;
        out.output = executor.read_image(handles.output);
        for (const Step& step : executor.plan().steps) {
            const bool is_shadow = graph.passes()[step.pass].name.starts_with("shadow of ");
            out.shadows_drawn += is_shadow ? 1 : 0;
        }
        return out;
    }

    /// The same by an executor that has nothing of an earlier frame.
    static Frame fresh(const Loaded& loaded, const FrameSettings& settings) {
        Executor executor(device());
        return frame(executor, loaded, settings);
    }
};

TEST_F(KeptShadowsTest, a_still_light_draws_its_shadow_once_and_changes_no_bit) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    Executor executor(device());
    const int lights = fresh(loaded, settings).shadows_drawn;
    ASSERT_GE(lights, 2);
    for (int number = 0; number < 5; ++number) {
        settings.orbit.azimuth += 5; // the camera moves, and with it what is seen
        const Frame kept = frame(executor, loaded, settings);
        EXPECT_EQ(kept.shadows_drawn, number == 0 ? lights : 0) << number;
        EXPECT_EQ(kept.output, fresh(loaded, settings).output) << number;
        settings.force_all = true;
        Executor other(device());
        EXPECT_EQ(frame(other, loaded, settings).shadows_drawn, lights);
        EXPECT_EQ(frame(other, loaded, settings).shadows_drawn, lights) << "with all forced";
        settings.force_all = false;
    }
    EXPECT_EQ(executor.rebuilds(), 1U);
}

TEST_F(KeptShadowsTest, what_a_shadow_shows_draws_it_again_and_what_it_does_not_leaves_it) {
    struct Change {
        const char* what;
        bool draws;
        std::function<void(Loaded&, FrameSettings&)> make;
    };
    const Change changes[] = {
        {"a light's place", true,
         [](Loaded& it, FrameSettings&) { it.scene.lights[0].position.x += 0.3F; }},
        {"a light's aim", true,
         [](Loaded& it, FrameSettings&) { it.scene.lights[0].aim.x += 0.3F; }},
        {"a light's angle", true,
         [](Loaded& it, FrameSettings&) { it.scene.lights[0].shadow_angle += 5; }},
        {"a light that casts none", true,
         [](Loaded& it, FrameSettings&) { it.scene.lights[0].casts_shadow = false; }},
        {"a caster's place", true,
         [](Loaded& it, FrameSettings&) {
             for (Object& object : it.scene.objects) {
                 if (object.casts_shadow) {
                     object.transform = glm::translate(object.transform, {0.1F, 0.05F, 0});
                 }
             }
         }},
        {"who casts", true,
         [](Loaded& it, FrameSettings&) {
             const auto caster = std::find_if(it.scene.objects.begin(), it.scene.objects.end(),
                                              [](const Object& o) { return o.casts_shadow; });
             caster->casts_shadow = false;
         }},
        {"a light that goes out", true,
         [](Loaded& it, FrameSettings&) { it.scene.lights[0].is_on = false; }},
        {"the maps' size", true,
         [](Loaded&, FrameSettings& settings) { settings.shadow_size = 128; }},
        {"a light's intensity", false,
         [](Loaded& it, FrameSettings&) { it.scene.lights[0].intensity *= 0.5F; }},
        {"a material", false,
         [](Loaded& it, FrameSettings&) { it.scene.materials[0].albedo *= 0.5F; }},
        {"an object that casts nothing", false,
         [](Loaded& it, FrameSettings&) {
             for (Object& object : it.scene.objects) {
                 if (!object.casts_shadow) {
                     object.transform = glm::translate(object.transform, {0, 0.05F, 0});
                 }
             }
         }},
        {"the exposure", false, [](Loaded&, FrameSettings& settings) { settings.exposure += 1; }},
    };
    for (const Change& change : changes) {
        Loaded loaded(scene_at(*scene_named("studio"), 0));
        FrameSettings settings = settings_for(loaded.scene);
        Executor executor(device());
        const Frame before = frame(executor, loaded, settings);
        change.make(loaded, settings);
        const Frame after = frame(executor, loaded, settings);
        EXPECT_EQ(after.shadows_drawn > 0, change.draws) << change.what;
        EXPECT_TRUE(after.output != before.output) << change.what;
        EXPECT_TRUE(after.output == fresh(loaded, settings).output) << change.what;
        EXPECT_EQ(frame(executor, loaded, settings).shadows_drawn, 0) << change.what;
    }
}

TEST_F(KeptShadowsTest, another_model_in_the_same_place_draws_its_own_shadows) {
    Scene scene = scene_at(*scene_named("studio"), 0);
    const Loaded first(scene);
    for (Mesh& mesh : scene.meshes) {
        for (Vertex& vertex : mesh.vertices) {
            vertex.position *= 0.8F; // as many vertices and triangles, and no transform changes
        }
    }
    const Loaded second(scene);
    const FrameSettings settings = settings_for(scene);
    Executor executor(device());
    frame(executor, first, settings);
    const Frame other = frame(executor, second, settings);
    EXPECT_GT(other.shadows_drawn, 0);
    EXPECT_EQ(other.output, fresh(second, settings).output);
}

TEST_F(KeptShadowsTest, a_frame_without_shadows_drops_them_and_the_next_draws_them_again) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    Executor executor(device());
    const Frame first = frame(executor, loaded, settings);
    settings.without.set(Effect::shadows, true);
    EXPECT_EQ(frame(executor, loaded, settings).shadows_drawn, 0);
    settings.without = {};
    const Frame again = frame(executor, loaded, settings);
    EXPECT_EQ(again.shadows_drawn, first.shadows_drawn);
    EXPECT_EQ(again.output, first.output);
}

TEST_F(KeptShadowsTest, a_view_of_the_kept_maps_shows_what_a_view_of_new_ones_shows) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    Executor executor(device());
    frame(executor, loaded, settings);
    settings.view = debug_view_named("shadows");
    const Frame kept = frame(executor, loaded, settings);
    EXPECT_EQ(kept.shadows_drawn, 0);
    EXPECT_EQ(kept.output, fresh(loaded, settings).output);
}

TEST_F(KeptShadowsTest, frames_in_flight_that_move_a_light_and_rest_in_turn_are_synchronised) {
    Loaded loaded(scene_at(*scene_named("studio"), 0));
    const FrameSettings settings = settings_for(loaded.scene);
    Executor executor(device());
    FrameHandles handles;
    for (int number = 0; number < 8; ++number) {
        loaded.scene.lights[0].position.x += number % 3 == 0 ? 0.1F : 0;
        Graph graph;
        handles = build_frame(graph, loaded.inputs(), settings);
        executor.render(graph); // nobody waits
    }
    EXPECT_EQ(executor.read_image(handles.output), fresh(loaded, settings).output);
}

TEST_F(KeptShadowsTest, the_explanation_says_why_they_are_still_right) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    Executor executor(device());
    const Rendered rendered = render_frame(executor, loaded.inputs(), settings_for(loaded.scene));
    const std::size_t at = rendered.explanation.find("left out  shadow of light key ");
    ASSERT_NE(at, std::string::npos) << rendered.explanation;
    const std::string line =
        rendered.explanation.substr(at, rendered.explanation.find('\n', at) - at);
    EXPECT_TRUE(line.ends_with("kept from an earlier frame: no light or caster has moved")) << line;
}

} // namespace
} // namespace preview
