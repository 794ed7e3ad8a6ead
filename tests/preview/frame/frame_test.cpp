// The whole frame on a device: what it leaves out, that leaving out changes nothing, and that a
// steady frame costs nothing but its passes.
#include "lutlib/error.h"
#include "preview/effects/effect.h"
#include "preview/frame/frame.h"
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "preview/passes/copy.h"
#include "tests/preview/frame/frame_fixture.h"

#include <algorithm>
#include <cmath>

namespace preview {
namespace {

/// Whether some channel, alpha apart, has more than one value.
bool has_contrast(const Rendered& rendered) {
    for (std::size_t at = 4; at < rendered.rgba.size(); at += 4) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (rendered.rgba[at + c] != rendered.rgba[c]) {
                return true;
            }
        }
    }
    return false;
}

TEST_F(FrameTest, everything_forced_on_equals_the_automatic_frame_bit_for_bit) {
    for (const SceneInfo& info : scenes()) {
        const Loaded loaded(scene_at(info, 1.5));
        FrameSettings settings = settings_for(loaded.scene);
        Executor executor(device());
        const Rendered automatic = render_frame(executor, loaded.inputs(), settings);
        settings.force_all = true;
        const Rendered forced = render_frame(executor, loaded.inputs(), settings);
        EXPECT_EQ(automatic.rgba, forced.rgba) << info.name;
        EXPECT_TRUE(kept(forced, "bloom 0")) << forced.explanation;
    }
}

TEST_F(FrameTest, a_plain_scene_leaves_out_shadows_and_bloom_and_says_why) {
    const Loaded loaded(scene_at(*scene_named("plain"), 0));
    Executor executor(device());
    const Rendered rendered = render_frame(executor, loaded.inputs(), settings_for(loaded.scene));
    EXPECT_FALSE(kept(rendered, "bloom 0")) << rendered.explanation;
    for (const char* reason : {"the light casts none", "no light is bright enough to bloom"}) {
        EXPECT_NE(rendered.explanation.find(reason), std::string::npos) << rendered.explanation;
    }
    // g-buffer, lighting, clear, resolve, finish, fxaa
    EXPECT_EQ(executor.plan().steps.size(), 6U) << rendered.explanation;
}

TEST_F(FrameTest, the_studio_keeps_its_shadows_and_blooms) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    Executor executor(device());
    const Rendered rendered = render_frame(executor, loaded.inputs(), settings_for(loaded.scene));
    for (const char* pass : {"g-buffer", "lighting", "hdr resolve", "bloom 0", "finish", "fxaa"}) {
        EXPECT_TRUE(kept(rendered, pass)) << pass << "\n" << rendered.explanation;
    }
}

TEST_F(FrameTest, without_light_above_white_has_no_bloom_and_says_why_a_look_is_left_out) {
    const Loaded loaded(scene_at(*scene_named("plain"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    settings.bloom_settings = {};
    FrameInputs inputs = loaded.inputs();
    inputs.no_look[0] = "it changes less than half an output code";
    Executor executor(device());
    const Rendered rendered = render_frame(executor, inputs, settings);
    EXPECT_NE(rendered.explanation.find("no light is bright enough to bloom"), std::string::npos);
    EXPECT_NE(rendered.explanation.find("it changes less"), std::string::npos);
    EXPECT_EQ(rendered.explanation.find("there is none"), std::string::npos);
    EXPECT_NE(rendered.explanation.find("finished 160x90"), std::string::npos);
}

TEST_F(FrameTest, shows_the_numbers_of_intermediates_where_they_are_asked_for) {
    const Loaded loaded(scene_at(*scene_named("plain"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    settings.format = Format::rgba32f;
    settings.shows_numbers = true;
    settings.view = debug_view_named("depth");
    Executor executor(device());
    const std::size_t centre = 4 * (std::size_t{size.width} * (size.height / 2) + size.width / 2);
    const Rendered depth = render_frame(executor, loaded.inputs(), settings);
    EXPECT_NEAR(depth.values[centre] / loaded.scene.orbit.distance, 1, 0.5); // in metres
    settings.view = debug_view_named("normal");
    const Rendered normal = render_frame(executor, loaded.inputs(), settings);
    EXPECT_NEAR(
        std::hypot(normal.values[centre], normal.values[centre + 1], normal.values[centre + 2]), 1,
        1e-3);
}

TEST_F(FrameTest, every_effect_can_be_switched_off_and_is_said_to_be) {
    Scene scene = scene_at(*scene_named("studio"), 0);
    scene.floor = 0;
    const Loaded loaded(std::move(scene));
    const GpuLook look(device(), look_for(inverting_look(), *gpu_lookup_named("tetrahedral")).data);
    FrameInputs inputs = loaded.inputs();
    inputs.look_a = &look;
    inputs.names = {"inverting", "none"};
    FrameSettings settings = settings_for(loaded.scene);
    settings.compare = &compare_split;
    Executor executor(device());
    const Rendered whole = render_frame(executor, inputs, settings);
    EXPECT_EQ(whole.explanation.find("switched off"), std::string::npos) << whole.explanation;
    for (const EffectInfo& row : effects) {
        settings.without = {};
        settings.without.set(row.effect, true);
        const Rendered rendered = render_frame(executor, inputs, settings);
        EXPECT_NE(rendered.rgba, whole.rgba) << row.name;
        const std::size_t at = rendered.explanation.find("left out  " + std::string(row.name));
        ASSERT_NE(at, std::string::npos) << rendered.explanation;
        EXPECT_NE(rendered.explanation.find("switched off", at), std::string::npos) << row.name;
        settings.force_all = true; // what a person switched off stays off
        EXPECT_EQ(render_frame(executor, inputs, settings).rgba, rendered.rgba) << row.name;
        settings.force_all = false;
    }
    for (const EffectInfo& row : effects) {
        settings.without.set(row.effect, true);
    }
    settings.effects.clear();
    render_frame(executor, inputs, settings);
    // g-buffer, lighting, clear, resolve, finish
    EXPECT_EQ(executor.plan().steps.size(), 5U);
}

TEST_F(FrameTest, every_effect_changes_the_picture_is_shown_by_its_view_and_costs_nothing_at_0) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    settings.effects.clear();
    Executor executor(device());
    const Rendered plain = render_frame(executor, loaded.inputs(), settings);
    const std::size_t steps = executor.plan().steps.size();
    for (const PostEffect* effect : post_effects()) {
        const std::string name(effect->name);
        settings.effects = {usual_use(*effect)};
        const Rendered whole = render_frame(executor, loaded.inputs(), settings);
        EXPECT_NE(whole.rgba, plain.rgba) << name;
        EXPECT_TRUE(kept(whole, name)) << whole.explanation;
        settings.effect_view = effect;
        const Rendered alone = render_frame(executor, loaded.inputs(), settings);
        EXPECT_TRUE(has_contrast(alone)) << name;
        EXPECT_TRUE(kept(alone, name)) << alone.explanation;
        settings.effects.front().values.front() = 0.0;
        EXPECT_THROW(render_frame(executor, loaded.inputs(), settings), lutlib::UsageError);
        settings.effect_view = nullptr;
        const Rendered without = render_frame(executor, loaded.inputs(), settings);
        EXPECT_EQ(without.rgba, plain.rgba) << name;
        EXPECT_EQ(executor.plan().steps.size(), steps) << name;
        const std::size_t at = without.explanation.find("left out  " + name + " ");
        ASSERT_NE(at, std::string::npos) << without.explanation;
        const std::string line =
            without.explanation.substr(at, without.explanation.find('\n', at) - at);
        EXPECT_TRUE(line.ends_with("its strength is 0")) << line;
    }
}

TEST_F(FrameTest, an_effect_between_bloom_and_tone_map_sees_the_light_with_its_bloom) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    // Twice itself: changes nothing but where the bloom is composited.
    PostEffect nothing = *post_effect_named("vignette");
    nothing.stage = Stage::before_tonemap;
    nothing.add = [](Graph& graph, const EffectInput& in, const lutlib::Values&) {
        return add_copy(graph, in.picture, Format::rgba16f);
    };
    FrameSettings settings = settings_for(loaded.scene);
    settings.effects.clear(); // antialiasing decides by thresholds
    settings.probe = {80, 45};
    Executor executor(device());
    const Rendered fused = render_frame(executor, loaded.inputs(), settings);
    EXPECT_NE(fused.explanation.find("left out  bloom composite"), std::string::npos);
    settings.effects.push_back(usual_use(nothing));
    const Rendered apart = render_frame(executor, loaded.inputs(), settings);
    EXPECT_TRUE(kept(apart, "bloom composite")) << apart.explanation;
    int most = 0;
    for (std::size_t at = 0; at < fused.rgba.size(); ++at) {
        most = std::max(most, std::abs(int{fused.rgba[at]} - int{apart.rgba[at]}));
    }
    EXPECT_LE(most, 1); // the composite is rounded to half floats
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(apart.probe->before[c], fused.probe->before[c], 2e-3);
    }
}

TEST_F(FrameTest, the_split_line_is_drawn_over_what_effects_make_of_the_picture) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    settings.compare = &compare_split;
    Executor executor(device());
    const Rendered smooth = render_frame(executor, loaded.inputs(), settings);
    EXPECT_TRUE(kept(smooth, "split line")) << smooth.explanation;
    settings.effects.clear();
    const Rendered fused = render_frame(executor, loaded.inputs(), settings);
    EXPECT_FALSE(kept(fused, "split line"));
    EXPECT_NE(fused.explanation.find("left out  split line"), std::string::npos);
    const auto is_white = [](const Rendered& rendered, std::size_t x, std::size_t y) {
        const std::size_t at = 4 * (y * rendered.size.width + x);
        return rendered.rgba[at] == 255 && rendered.rgba[at + 1] == 255 &&
               rendered.rgba[at + 2] == 255;
    };
    for (std::size_t y = 0; y < size.height; ++y) {
        EXPECT_TRUE(is_white(smooth, size.width / 2, y)) << y;
        EXPECT_TRUE(is_white(fused, size.width / 2, y)) << y;
    }
    // Without a line to smooth, the antialiased sides are those of a picture without comparison.
    settings = settings_for(loaded.scene);
    const Rendered alone = render_frame(executor, loaded.inputs(), settings);
    for (std::size_t at = 0; at < alone.rgba.size(); ++at) {
        const std::size_t x = at / 4 % size.width;
        if (x + 1 < size.width / 2 || x > size.width / 2) {
            ASSERT_EQ(smooth.rgba[at], alone.rgba[at]) << at;
        }
    }
}

TEST_F(FrameTest, a_light_that_is_off_leaves_the_frame_with_its_shadow) {
    Loaded loaded(scene_at(*scene_named("studio"), 0));
    const FrameSettings settings = settings_for(loaded.scene);
    Executor executor(device());
    loaded.scene.lights[0].is_on = false;
    const Rendered off = render_frame(executor, loaded.inputs(), settings);
    EXPECT_NE(off.explanation.find("left out  light key "), std::string::npos) << off.explanation;
    EXPECT_EQ(off.explanation.find("shadow of light key"), std::string::npos);
    EXPECT_NE(off.explanation.find("shadow of light spark"), std::string::npos);
    loaded.scene.lights.erase(loaded.scene.lights.begin());
    EXPECT_EQ(render_frame(executor, loaded.inputs(), settings).rgba, off.rgba);
}

TEST_F(FrameTest, every_debug_view_shows_something_and_runs_only_what_it_reads) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    Executor executor(device());
    Graph whole; // with shadow maps, which views in between do not keep
    build_frame(whole, loaded.inputs(), settings);
    executor.render(whole);
    const std::size_t whole_steps = executor.plan().steps.size();
    for (const DebugView& view : debug_views()) {
        settings.view = &view;
        const Rendered rendered = render_frame(executor, loaded.inputs(), settings);
        EXPECT_TRUE(has_contrast(rendered)) << view.name;
        EXPECT_LE(executor.plan().steps.size(), whole_steps) << view.name;
        EXPECT_EQ(kept(rendered, "finish"), view.name == "graded") << view.name;
    }
    settings.view = debug_view_named("normal");
    const Rendered normals = render_frame(executor, loaded.inputs(), settings);
    EXPECT_EQ(executor.plan().steps.size(), 2U);
    EXPECT_TRUE(kept(normals, "g-buffer"));
    EXPECT_EQ(normals.explanation.find("material 160x90"), std::string::npos);
}

TEST_F(FrameTest, a_view_of_what_the_frame_withholds_is_an_error) {
    const Loaded loaded(scene_at(*scene_named("plain"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    settings.view = debug_view_named("shadows");
    Executor executor(device());
    EXPECT_THROW(render_frame(executor, loaded.inputs(), settings), lutlib::UsageError);
}

TEST_F(FrameTest, a_steady_frame_allocates_and_uploads_nothing) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    const GpuLook look(device(), look_for(inverting_look(), *gpu_lookup_named("tetrahedral")).data);
    FrameInputs inputs = loaded.inputs();
    inputs.look_a = &look;
    const FrameSettings settings = settings_for(loaded.scene);
    Executor executor(device());
    const auto render = [&] {
        Graph graph;
        build_frame(graph, inputs, settings);
        executor.render(graph);
    };
    for (int frame = 0; frame < 3; ++frame) {
        render();
    }
    const std::uint64_t allocations = device().allocation_count();
    const std::uint64_t uploads = executor.uploads();
    for (int frame = 0; frame < 4; ++frame) {
        render();
    }
    EXPECT_EQ(device().allocation_count(), allocations);
    EXPECT_EQ(executor.uploads(), uploads);
    EXPECT_EQ(executor.rebuilds(), 1U);
    EXPECT_LT(executor.pool_bytes(), executor.unshared_bytes());
}

TEST_F(FrameTest, an_animated_scene_uploads_only_what_moves) {
    Loaded loaded(scene_at(*scene_named("studio"), 0));
    const FrameSettings settings = settings_for(loaded.scene);
    Executor executor(device());
    for (int frame = 0; frame < 3; ++frame) {
        loaded.scene = scene_at(*scene_named("studio"), frame * 0.1);
        Graph graph;
        build_frame(graph, loaded.inputs(), settings);
        const std::uint64_t before = executor.uploads();
        executor.render(graph);
        if (frame > 0) {
            EXPECT_EQ(executor.uploads() - before, 3U) << "objects, casters and lights";
        }
    }
    EXPECT_EQ(executor.rebuilds(), 1U);
}

TEST_F(FrameTest, a_light_that_changes_is_all_that_is_uploaded) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    std::vector<PointLight> lights = loaded.scene.lights;
    FrameInputs inputs = loaded.inputs();
    inputs.lights = &lights;
    const FrameSettings settings = settings_for(loaded.scene);
    Executor executor(device());
    const Rendered before = render_frame(executor, inputs, settings);
    for (PointLight& light : lights) {
        light.intensity *= 0.5F;
        light.position += glm::vec3(0.1F);
        const std::uint64_t uploads = executor.uploads();
        const std::uint64_t rebuilds = executor.rebuilds();
        Graph graph;
        build_frame(graph, inputs, settings);
        executor.render(graph);
        EXPECT_EQ(executor.uploads() - uploads, 1U) << light.name;
        EXPECT_EQ(executor.rebuilds(), rebuilds) << light.name;
    }
    EXPECT_NE(render_frame(executor, inputs, settings).rgba, before.rgba);
}

TEST_F(FrameTest, the_same_moment_renders_the_same_picture_and_another_one_does_not) {
    Executor executor(device());
    const auto at = [&](double seconds) {
        const Loaded loaded(scene_at(*scene_named("studio"), seconds));
        return render_frame(executor, loaded.inputs(), settings_for(loaded.scene)).rgba;
    };
    const auto picture = at(2);
    EXPECT_EQ(picture, at(2));
    EXPECT_NE(picture, at(3));
}

TEST_F(FrameTest, a_look_reaches_its_own_side_only) {
    const Loaded loaded(scene_at(*scene_named("chart"), 0));
    const GpuLook look(device(), look_for(inverting_look(), *gpu_lookup_named("tetrahedral")).data);
    FrameInputs inputs = loaded.inputs();
    FrameSettings settings = settings_for(loaded.scene);
    settings.effects.clear();
    Executor executor(device());
    const auto plain = render_frame(executor, inputs, settings).rgba;
    inputs.look_b = &look;
    EXPECT_EQ(render_frame(executor, inputs, settings).rgba, plain);
    settings.compare = compare_named("b");
    const auto graded = render_frame(executor, inputs, settings).rgba;
    EXPECT_NE(graded, plain);
    settings.compare = compare_named("split");
    const auto split = render_frame(executor, inputs, settings).rgba;
    const std::size_t row = std::size_t{size.height / 2} * size.width * 4;
    EXPECT_TRUE(std::equal(split.begin() + static_cast<long>(row),
                           split.begin() + static_cast<long>(row + 4 * 70),
                           plain.begin() + static_cast<long>(row)));
    EXPECT_TRUE(std::equal(split.begin() + static_cast<long>(row + 4 * 90),
                           split.begin() + static_cast<long>(row + 4 * 160),
                           graded.begin() + static_cast<long>(row + 4 * 90)));
}

TEST(LookBakeTest, a_look_that_does_nothing_is_skipped_and_says_so) {
    lutlib::Lut look;
    look.cube = lutlib::identity_cube(16);
    for (const GpuLookup& lookup : gpu_lookups()) {
        if (lookup.source == GpuLookup::Source::none) {
            continue;
        }
        EXPECT_NE(look_for(look, lookup).skip_reason, "") << lookup.name;
        EXPECT_EQ(look_for(inverting_look(), lookup).skip_reason, "") << lookup.name;
    }
    look.cube->nodes[7].r = std::nanf("");
    EXPECT_EQ(skip_reason_of(look), "");
    look.cube = lutlib::identity_cube(16, {{0, 0, 0}, {2, 2, 2}});
    EXPECT_EQ(skip_reason_of(look), "");
}

} // namespace
} // namespace preview
