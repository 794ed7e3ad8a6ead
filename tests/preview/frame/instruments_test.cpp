// What measures a frame on a device: scopes, the probe and counts along curves' axes.
#include "lutlib/error.h"
#include "preview/finish/curve_counts.h"
#include "preview/finish/metering.h"
#include "preview/frame/measured.h"
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "tests/preview/frame/frame_fixture.h"

#include <algorithm>
#include <cmath>

namespace preview {
namespace {

TEST_F(FrameTest, scopes_are_left_out_until_somebody_looks_and_change_nothing_else) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    Executor executor(device());
    const Rendered plain = render_frame(executor, loaded.inputs(), settings);
    const std::size_t steps = executor.plan().steps.size();
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        const std::string name(scopes[i].name);
        EXPECT_FALSE(kept(plain, "count " + name));
        EXPECT_NE(plain.explanation.find("left out  " + name), std::string::npos);
        settings.scope_sizes[i] = {200, 120};
        const Rendered beside = render_frame(executor, loaded.inputs(), settings);
        EXPECT_EQ(beside.rgba, plain.rgba) << name;
        EXPECT_TRUE(kept(beside, "count " + name)) << beside.explanation;
        EXPECT_GT(executor.plan().steps.size(), steps);
        settings.scope = &scopes[i];
        const Rendered alone = render_frame(executor, loaded.inputs(), settings);
        EXPECT_EQ(alone.size, (Size{200, 120})) << name;
        EXPECT_NE(alone.rgba, plain.rgba) << name;
        settings.scope = nullptr;
        settings.scope_sizes[i] = {};
    }
}

TEST_F(FrameTest, levels_in_another_encoding_are_of_every_scope_but_the_vectorscope) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    settings.scope_sizes.fill({800, 120}); // a column for each of the picture's
    settings.keeps_scopes = true;
    Executor executor(device());
    for (const Scope& scope : scopes) {
        settings.scope = &scope;
        settings.scope_levels = {};
        const Rendered shown = render_frame(executor, loaded.inputs(), settings);
        EXPECT_FALSE(kept(shown, "encode for scopes"));
        settings.scope_levels.encoding = lutlib::encoding_named("pq");
        const Rendered encoded = render_frame(executor, loaded.inputs(), settings);
        EXPECT_TRUE(kept(encoded, "encode for scopes"));
        EXPECT_EQ(encoded.scope_counts.size(), shown.scope_counts.size());
        EXPECT_EQ(encoded.scope_counts != shown.scope_counts, has_levels(scope)) << scope.name;
        EXPECT_EQ(encoded.rgba != shown.rgba, has_levels(scope)) << scope.name;
        // As it is shown, of whatever white.
        settings.scope_levels.shown = *settings.scope_levels.encoding;
        settings.scope_levels.white = 400;
        const Rendered own = render_frame(executor, loaded.inputs(), settings);
        EXPECT_FALSE(kept(own, "encode for scopes"));
        EXPECT_EQ(own.scope_counts, shown.scope_counts) << scope.name;
        EXPECT_EQ(own.rgba != shown.rgba, has_levels(scope)) << "the figures are others";
    }
}

TEST_F(FrameTest, a_scope_of_what_is_not_shown_is_an_error_and_beside_the_picture_left_out) {
    const Loaded loaded(scene_at(*scene_named("plain"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    settings.scope_sizes[0] = {64, 64};
    settings.compare = &compare_difference;
    Executor executor(device());
    EXPECT_FALSE(kept(render_frame(executor, loaded.inputs(), settings), "count waveform"));
    settings.scope = &scopes[0];
    EXPECT_THROW(render_frame(executor, loaded.inputs(), settings), lutlib::UsageError);
    settings.compare = &compares[0];
    settings.scope_side = &scope_sides[2];
    EXPECT_THROW(render_frame(executor, loaded.inputs(), settings), lutlib::UsageError);
}

TEST_F(FrameTest, a_probe_tells_both_sides_of_the_same_texel_whatever_is_compared) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    const GpuLook look(device(), look_for(inverting_look(), *gpu_lookup_named("tetrahedral")).data);
    FrameInputs inputs = loaded.inputs();
    inputs.look_b = &look;
    FrameSettings settings = settings_for(loaded.scene);
    settings.effects.clear();
    Executor executor(device());
    const auto codes_at = [](const Rendered& rendered, std::int32_t x, std::int32_t y) {
        const std::size_t at =
            4 * (static_cast<std::size_t>(y) * rendered.size.width + static_cast<std::size_t>(x));
        return std::array<int, 3>{rendered.rgba[at], rendered.rgba[at + 1], rendered.rgba[at + 2]};
    };
    const auto codes = [](lutlib::RgbD color) {
        const Codes out = codes_of(color);
        return std::array<int, 3>{out.r, out.g, out.b};
    };
    for (const Compare& compare : compares) {
        settings.compare = &compare;
        settings.split = 0.25F;
        settings.box_x = 0.7F; // which leaves the texel to side B
        settings.probe = {90, 41};
        const Rendered rendered = render_frame(executor, inputs, settings);
        ASSERT_TRUE(rendered.probe) << compare.name;
        EXPECT_EQ(rendered.probe->a, rendered.probe->before) << compare.name;
        EXPECT_NE(rendered.probe->b, rendered.probe->before) << compare.name;
        if (&compare == &compare_difference) {
            continue;
        }
        // Side by side, 90 is the tenth column of B.
        EXPECT_EQ(codes_at(rendered, 90, 41),
                  codes(compare.shows_b ? rendered.probe->b : rendered.probe->a))
            << compare.name;
    }
    settings.probe.reset();
    EXPECT_FALSE(kept(render_frame(executor, inputs, settings), "probe"));
}

TEST_F(FrameTest, metering_makes_the_place_or_the_mean_18_percent_grey_at_any_exposure) {
    const Loaded loaded(scene_at(*scene_named("studio"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    settings.bloom = bloom_named("none");
    settings.exposure = 1.5F; // which metering does not add to
    Executor executor(device());
    constexpr ProbePlace place{80, 60};
    settings.exposure = metered_exposure(executor, loaded.inputs(), settings, place).value();
    settings.probe = place;
    const Rendered spot = render_frame(executor, loaded.inputs(), settings);
    const lutlib::RgbD light = spot.probe.value().light;
    EXPECT_NEAR(0.2126 * light.r + 0.7152 * light.g + 0.0722 * light.b, metered_grey, 2e-4);
    const float metered = settings.exposure;
    for (const float exposure : {-12.0F, -0.013F, 3.37F, 11.0F}) {
        settings.exposure = exposure;
        EXPECT_EQ(metered_exposure(executor, loaded.inputs(), settings, place), metered)
            << exposure;
    }

    settings.exposure = metered_exposure(executor, loaded.inputs(), settings, {}).value();
    settings.keep_hdr = true;
    const Rendered all = render_frame(executor, loaded.inputs(), settings);
    double stops = 0;
    for (std::size_t at = 0; at < all.hdr.size(); at += 4) {
        const auto channel = [&](std::size_t c) { return static_cast<double>(all.hdr[at + c]); };
        stops += std::log2(
            std::max(0.2126 * channel(0) + 0.7152 * channel(1) + 0.0722 * channel(2), 1e-6));
    }
    EXPECT_NEAR(std::exp2(4 * stops / static_cast<double>(all.hdr.size())), metered_grey, 2e-3);
    EXPECT_EQ(all.hdr_size, size);
}

TEST_F(FrameTest, metering_a_place_has_all_digits_of_light_that_half_floats_have_not) {
    Executor executor(device());
    for (const float light : {1e-7F, 3e-4F, 0.18F, 9e4F}) {
        const std::vector<float> rgba{light, light, light, 1, 0.5F, 0.5F, 0.5F, 1};
        const GpuPicture picture(device(), {2, 1}, rgba, false);
        FrameInputs inputs;
        inputs.picture = &picture;
        FrameSettings settings;
        settings.output = {2, 1};
        settings.bloom = bloom_named("none");
        EXPECT_NEAR(metered_exposure(executor, inputs, settings, ProbePlace{0, 0}).value(),
                    std::clamp(std::log2(0.18F / light), -20.0F, 20.0F), 1e-3F)
            << light;
        // Twice as large as it is, and side by side, where the second half is its left texel again.
        settings.output = {4, 2};
        settings.zoom.scale = 2;
        EXPECT_NEAR(metered_exposure(executor, inputs, settings, ProbePlace{3, 1}).value(),
                    std::log2(0.36F), 1e-3F);
        settings.zoom = {};
        settings.output = {4, 1};
        settings.compare = &compare_side;
        EXPECT_NEAR(metered_exposure(executor, inputs, settings, ProbePlace{3, 0}).value(),
                    std::log2(0.36F), 1e-3F);
    }
}

TEST_F(FrameTest, axes_are_counted_only_while_a_curve_is_seen) {
    const Loaded loaded(scene_at(*scene_named("chart"), 0));
    FrameSettings settings = settings_for(loaded.scene);
    Executor executor(device());
    EXPECT_FALSE(kept(render_frame(executor, loaded.inputs(), settings), "count along axes"));
    settings.axes = &lutlib::srgb();
    EXPECT_TRUE(kept(render_frame(executor, loaded.inputs(), settings), "count along axes"));
    const std::vector<std::byte> counts = executor.finished_buffer("axis counts");
    EXPECT_EQ(counts.size(), counted_axes.size() * axis_bins * sizeof(std::uint32_t));
    EXPECT_NE(std::count(counts.begin(), counts.end(), std::byte{0}),
              static_cast<std::ptrdiff_t>(counts.size()));
}

} // namespace
} // namespace preview
