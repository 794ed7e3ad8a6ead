// The light that the looks get, from frame to frame: drawn when something of it has changed and
// only then, and never to be told from light that every frame draws anew.
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "tests/preview/frame/frame_fixture.h"

#include <functional>
#include <set>
#include <string>

namespace preview {
namespace {

using Names = std::set<std::string>;

class KeptLightTest : public FrameTest {
  protected:
    struct Frame {
        Names passes; ///< that ran; all of a bloom's are "bloom"
        std::vector<std::byte> output;
    };

    static FrameSettings keeping(const Scene& scene) {
        FrameSettings settings = settings_for(scene);
        settings.keeps_light = true;
        return settings;
    }

    static Frame frame(Executor& executor, const FrameInputs& inputs,
                       const FrameSettings& settings) {
        Graph graph;
        const FrameHandles handles = build_frame(graph, inputs, settings);
        executor.render(graph);
        Frame out;
        out.output = executor.read_image(handles.output);
        for (const Step& step : executor.plan().steps) {
            const std::string& name = graph.passes()[step.pass].name;
            out.passes.insert(name.starts_with("bloom") ? "bloom" : name);
        }
        return out;
    }

    /// The same by an executor that has nothing of an earlier frame.
    static std::vector<std::byte> fresh(const FrameInputs& inputs, const FrameSettings& settings) {
        Executor executor(device());
        return frame(executor, inputs, settings).output;
    }
};

TEST_F(KeptLightTest, what_stands_behind_it_is_all_that_a_change_of_the_finish_draws) {
    struct Change {
        const char* what;
        Names draws;
        std::function<void(FrameInputs&, FrameSettings&)> make;
    };
    const GpuLook look(device(), look_for(inverting_look(), *gpu_lookup_named("trilinear")).data);
    const Names finish{"finish", "fxaa"};
    Names with_bloom = finish, with_line = finish;
    with_bloom.insert("bloom");
    with_line.insert("split line");
    const Change changes[] = {
        {"a look", finish, [&](FrameInputs& in, FrameSettings&) { in.look_a = &look; }},
        {"a comparison", with_line,
         [&](FrameInputs& in, FrameSettings& settings) {
             in.look_b = &look;
             settings.compare = &compare_split;
         }},
        {"the tone map", finish,
         [](FrameInputs&, FrameSettings& settings) {
             settings.tonemap = tonemap_named("reinhard");
         }},
        {"the bloom's strength", finish,
         [](FrameInputs&, FrameSettings& settings) { settings.bloom_settings.strength = 0.7F; }},
        {"what blooms", with_bloom,
         [](FrameInputs&, FrameSettings& settings) { settings.bloom_settings.threshold += 1; }},
    };
    for (const Change& change : changes) {
        const Loaded loaded(scene_at(*scene_named("studio"), 0));
        FrameInputs inputs = loaded.inputs();
        FrameSettings settings = keeping(loaded.scene);
        Executor executor(device());
        const Frame before = frame(executor, inputs, settings);
        EXPECT_TRUE(before.passes.contains("hdr resolve"));
        change.make(inputs, settings);
        const Frame after = frame(executor, inputs, settings);
        EXPECT_EQ(after.passes, change.draws) << change.what;
        EXPECT_TRUE(after.output != before.output) << change.what;
        EXPECT_TRUE(after.output == fresh(inputs, settings)) << change.what;
    }
}

TEST_F(KeptLightTest, is_drawn_again_when_anything_of_it_has_changed) {
    struct Change {
        const char* what;
        std::function<void(Loaded&, FrameSettings&)> make;
    };
    const Change changes[] = {
        {"the camera", [](Loaded&, FrameSettings& settings) { settings.orbit.azimuth += 3; }},
        {"the exposure", [](Loaded&, FrameSettings& settings) { settings.exposure += 1; }},
        {"a light", [](Loaded& it, FrameSettings&) { it.scene.lights[0].intensity *= 0.5F; }},
        {"a material", [](Loaded& it, FrameSettings&) { it.scene.materials[0].albedo *= 0.5F; }},
        {"an object",
         [](Loaded& it, FrameSettings&) { it.scene.objects[0].transform[3].y += 0.1F; }},
        {"the surroundings",
         [](Loaded& it, FrameSettings&) { it.scene.environment.zenith *= 2.0F; }},
        {"the ambient occlusion",
         [](Loaded&, FrameSettings& settings) { settings.occlusion.strength *= 0.5F; }},
        {"the size", [](Loaded&, FrameSettings& settings) { settings.output.width -= 2; }},
    };
    for (const Change& change : changes) {
        Loaded loaded(scene_at(*scene_named("studio"), 0));
        FrameSettings settings = keeping(loaded.scene);
        Executor executor(device());
        const Frame before = frame(executor, loaded.inputs(), settings);
        change.make(loaded, settings);
        const Frame after = frame(executor, loaded.inputs(), settings);
        EXPECT_TRUE(after.passes.contains("hdr resolve")) << change.what;
        EXPECT_TRUE(after.output != before.output) << change.what;
        EXPECT_TRUE(after.output == fresh(loaded.inputs(), settings)) << change.what;
    }
}

TEST_F(KeptLightTest, and_its_depth_serve_an_effect_that_asks_for_both) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = keeping(loaded.scene);
    settings.effects.push_back(parse_use("depth-of-field"));
    Executor executor(device());
    frame(executor, loaded.inputs(), settings);
    settings.tonemap = tonemap_named("reinhard");
    const Frame after = frame(executor, loaded.inputs(), settings);
    EXPECT_FALSE(after.passes.contains("g-buffer"));
    EXPECT_FALSE(after.passes.contains("hdr resolve"));
    EXPECT_EQ(after.output, fresh(loaded.inputs(), settings));
}

TEST_F(KeptLightTest, is_there_for_the_frame_that_follows_its_measurement) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = keeping(loaded.scene);
    settings.bloom_settings.threshold = 1; // so that it is asked whether anything blooms
    Executor executor(device());
    const Rendered rendered = render_frame(executor, loaded.inputs(), settings);
    EXPECT_FALSE(kept(rendered, "lighting")) << rendered.explanation;
    EXPECT_NE(rendered.explanation.find("scene, lights, camera and exposure are the same"),
              std::string::npos)
        << rendered.explanation;
    settings.keeps_light = false;
    Executor other(device());
    const Rendered whole = render_frame(other, loaded.inputs(), settings);
    EXPECT_TRUE(kept(whole, "lighting")) << whole.explanation;
    EXPECT_EQ(rendered.rgba, whole.rgba);
}

TEST_F(KeptLightTest, frames_in_flight_that_move_the_camera_and_rest_in_turn_are_synchronised) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = keeping(loaded.scene);
    Executor executor(device());
    FrameHandles handles;
    for (int number = 0; number < 8; ++number) {
        settings.orbit.azimuth += number % 3 == 0 ? 2.0F : 0.0F;
        settings.bloom_settings.strength += 0.01F;
        Graph graph;
        handles = build_frame(graph, loaded.inputs(), settings);
        executor.render(graph); // nobody waits
    }
    EXPECT_EQ(executor.read_image(handles.output), fresh(loaded.inputs(), settings));
}

} // namespace
} // namespace preview
