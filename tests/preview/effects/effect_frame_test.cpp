// Effects in whole frames: alone, in pairs, all at once, before and after the looks.
#include "preview/effects/effect.h"
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "preview/passes/copy.h"
#include "tests/preview/frame/frame_fixture.h"

#include <algorithm>
#include <cmath>

namespace preview {
namespace {

class EffectFrameTest : public FrameTest {
  protected:
    /// One for all: pipelines take longest to make.
    static Executor& executor() {
        static Executor made(device());
        return made;
    }

    static const Loaded& loaded() {
        static const Loaded made(scene_at(*scene_named("plain"), 0));
        return made;
    }

    /// Small, in floats, with bloom.
    static FrameSettings small_settings() {
        FrameSettings settings;
        settings.output = {64, 36};
        settings.orbit = loaded().scene.orbit;
        settings.bloom = bloom_named("dual-kawase");
        settings.bloom_settings.threshold = 0;
        settings.format = Format::rgba32f;
        settings.seconds = 0.7;
        return settings;
    }

    static Rendered rendered(const FrameSettings& settings) {
        return render_frame(executor(), loaded().inputs(), settings);
    }

    static void expect_a_picture(const Rendered& rendered, const std::string& name) {
        EXPECT_EQ(rendered.size, (Size{64, 36})) << name;
        EXPECT_TRUE(std::all_of(rendered.values.begin(), rendered.values.end(), [](float v) {
            return v >= 0 && v <= 1;
        })) << name;
    }
};

// Sharpening what is rounded already doubles its error and more.
TEST_F(EffectFrameTest, codes_are_rounded_once_after_all_effects) {
    FrameSettings settings = small_settings();
    settings.effects = {parse_use("sharpen")};
    const Rendered exact = rendered(settings);
    settings.format = Format::rgba8;
    const Rendered codes = rendered(settings);
    ASSERT_EQ(codes.rgba.size(), exact.values.size());
    double squares = 0;
    for (std::size_t i = 0; i < codes.rgba.size(); ++i) {
        const double off = codes.rgba[i] - 255.0 * exact.values[i];
        squares += off * off;
    }
    // Rounding alone leaves 1 / sqrt(12) = 0.289 of a code.
    EXPECT_LT(std::sqrt(squares / static_cast<double>(codes.rgba.size())), 0.35);
}

TEST_F(EffectFrameTest, any_two_effects_and_all_of_them_go_together) {
    FrameSettings settings = small_settings();
    const std::span<const PostEffect* const> all = post_effects();
    for (std::size_t a = 0; a < all.size(); ++a) {
        for (std::size_t b = a + 1; b < all.size(); ++b) {
            const std::string name =
                std::string(all[a]->name) + " and " + std::string(all[b]->name);
            settings.effects = {usual_use(*all[b]), usual_use(*all[a])};
            const Rendered once = rendered(settings);
            expect_a_picture(once, name);
            EXPECT_TRUE(kept(once, std::string(all[a]->name))) << name;
            EXPECT_TRUE(kept(once, std::string(all[b]->name))) << name;
        }
    }
    settings.effects.clear();
    for (const PostEffect* effect : all) {
        settings.effects.push_back(usual_use(*effect));
    }
    EXPECT_NE(rendered(settings).explanation.find(
                  "order     light, depth-of-field, chromatic-aberration, vignette, bloom, tone "
                  "map, looks, sharpen, pointillism, paintbrush, vaporwave, glitch, film-grain, "
                  "fxaa, line and names\n"),
              std::string::npos);
    for (const bool is_before_look : {false, true}) {
        for (EffectUse& use : settings.effects) {
            use.before_look = is_before_look;
        }
        const Rendered once = rendered(settings);
        expect_a_picture(once, "all");
        EXPECT_EQ(rendered(settings).values, once.values);
        settings.force_all = true;
        EXPECT_EQ(rendered(settings).values, once.values);
        settings.force_all = false;
    }
}

TEST_F(EffectFrameTest, after_the_look_an_effect_changes_the_finished_picture_with_its_bloom) {
    FrameSettings settings = small_settings();
    const Rendered plain = rendered(settings);
    const gpu::Image picture = upload({Format::rgba32f, 64, 36}, plain.values);
    for (const PostEffect* effect : post_effects()) {
        if (effect->stage != Stage::after_look || effect->needs_depth) {
            continue;
        }
        const EffectUse use = usual_use(*effect);
        settings.effects = {use};
        const Rendered whole = rendered(settings);
        EXPECT_TRUE(kept(whole, "bloom 0")) << effect->name;
        Graph graph;
        const ImageHandle alone = effect->add(
            graph, {graph.import("picture", picture, picture.desc()), 64, settings.seconds},
            use.values);
        graph.present(alone);
        executor().render(graph);
        EXPECT_EQ(as<float>(executor().read_image(alone)), whole.values) << effect->name;
        EXPECT_NE(whole.values, plain.values) << effect->name;
    }
}

TEST_F(EffectFrameTest, before_the_look_an_effect_changes_what_the_look_takes) {
    const GpuLook look(device(), look_for(inverting_look(), *gpu_lookup_named("tetrahedral")).data);
    FrameInputs inputs = loaded().inputs();
    inputs.look_a = &look;
    PostEffect nothing = *post_effect_named("sharpen");
    nothing.add = [](Graph& graph, const EffectInput& in, const lutlib::Values&) {
        return add_copy(graph, in.picture, Format::rgba16f);
    };
    FrameSettings settings = small_settings();
    const Rendered fused = render_frame(executor(), inputs, settings);
    EXPECT_FALSE(kept(fused, "tone map"));
    settings.effects = {usual_use(nothing)};
    settings.effects.front().before_look = true;
    const Rendered apart = render_frame(executor(), inputs, settings);
    EXPECT_TRUE(kept(apart, "tone map")) << apart.explanation;
    for (std::size_t at = 0; at < fused.values.size(); ++at) {
        ASSERT_NEAR(apart.values[at], fused.values[at], 1e-3) << at; // codes as halves
    }
    // A grain of grey before a look that swaps channels and inverts one is the inverse in that one.
    settings.effects = {parse_use("film-grain:strength=1,before-look=1")};
    const Rendered before = render_frame(executor(), inputs, settings);
    settings.effects = {parse_use("film-grain:strength=1")};
    const Rendered unlooked = rendered(settings);
    for (std::size_t at = 0; at < before.values.size(); at += 4) {
        ASSERT_NEAR(before.values[at], 1 - unlooked.values[at + 2], 2e-3) << at;
        ASSERT_NEAR(before.values[at + 1], unlooked.values[at], 2e-3) << at;
    }
}

/// The mean and the largest mean of a step of what differs from frame to frame, over a second and a
/// quarter of 24 frames, the camera panning by 3 degrees.
struct Steps {
    double mean = 0, most = 0;
};

TEST_F(EffectFrameTest, over_a_pan_of_30_frames_no_effect_pops) {
    const auto steps_with = [&](const EffectUses& uses) {
        FrameSettings settings = small_settings();
        settings.effects = uses;
        std::vector<float> before;
        Steps out;
        for (int frame = 0; frame < 30; ++frame) {
            settings.seconds = frame / 24.0;
            settings.orbit.azimuth =
                loaded().scene.orbit.azimuth + 0.1F * static_cast<float>(frame);
            const std::vector<float> now = rendered(settings).values;
            double sum = 0;
            for (std::size_t at = 0; at < before.size(); ++at) {
                sum += static_cast<double>(std::abs(now[at] - before[at]));
            }
            if (!before.empty()) {
                const double step = sum / (0.75 * static_cast<double>(now.size()));
                out.mean += step / 29;
                out.most = std::max(out.most, step);
            }
            before = now;
        }
        return out;
    };
    const Steps plain = steps_with({});
    // Beyond what the pan itself changes, in codes: noise and glitches change by their nature with
    // each step of their own time, by no more in any than their strength; all others go smoothly.
    struct Bound {
        const char* use;
        double most;
        double over_mean; ///< the largest step, of the mean one
    };
    for (const Bound& bound :
         {Bound{"film-grain", 0.04, 1.2}, Bound{"glitch", 0.08, 4}, Bound{"paintbrush", 0.015, 3},
          Bound{"vaporwave", 0.003, 2}, Bound{"pointillism", 0.003, 2},
          Bound{"depth-of-field:aperture=0.5,sensor=100", 0.003, 2}}) {
        const Steps steps = steps_with({parse_use(bound.use)});
        RecordProperty(bound.use, std::to_string(steps.most) + " of mean " +
                                      std::to_string(steps.mean) + ", without " +
                                      std::to_string(plain.most));
        EXPECT_LE(steps.most, plain.most + bound.most) << bound.use;
        EXPECT_LE(steps.most, bound.over_mean * steps.mean) << bound.use;
    }
}

TEST_F(EffectFrameTest, of_a_picture_no_effect_gets_a_depth) {
    const GpuPicture picture(device(), {64, 36}, std::vector<float>(4UL * 64 * 36, 0.5F), true);
    FrameInputs inputs;
    inputs.picture = &picture;
    FrameSettings settings = small_settings();
    for (const PostEffect* effect : post_effects()) {
        settings.effects = {usual_use(*effect)};
        const Rendered shown = render_frame(executor(), inputs, settings);
        EXPECT_EQ(kept(shown, std::string(effect->name)),
                  is_on_codes(effect->stage) && !effect->needs_depth)
            << effect->name;
        EXPECT_EQ(effect->needs_depth,
                  shown.explanation.find("it needs the depth of a scene") != std::string::npos)
            << effect->name;
    }
}

} // namespace
} // namespace preview
