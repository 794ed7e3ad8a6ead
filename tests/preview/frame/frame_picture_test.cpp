// A picture in place of a scene: what its frame leaves out, and how its codes reach the looks and
// the file.
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/transform.h"
#include "preview/frame/frame.h"
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "tests/preview/frame/frame_fixture.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace preview {
namespace {

TEST_F(FrameTest, codes_of_a_picture_reach_the_look_unrounded) {
    std::vector<float> texels;
    for (std::uint32_t i = 0; i < size.width * size.height; ++i) {
        for (const std::uint32_t code : {i, 7 * i + i / 256, 31 * i}) {
            texels.push_back(static_cast<float>(code % 256) / 255);
        }
        texels.push_back(1);
    }
    const GpuPicture picture(device(), size, texels, true);
    lutlib::Lut steep; // as far as codes go: a rounding before it shows after it
    steep.cube = lutlib::identity_cube(17);
    for (lutlib::Rgb& node : steep.cube->nodes) {
        node = {std::sqrt(node.r), 1 - node.g * node.g, std::sqrt(node.b * node.r)};
    }
    const GpuLook look(device(), look_data(steep, *gpu_lookup_named("trilinear")));
    FrameInputs inputs;
    inputs.picture = &picture;
    inputs.look_a = &look;
    FrameSettings settings = settings_for({});
    settings.effects.clear();
    Executor executor(device());
    const Rendered rendered = render_frame(executor, inputs, settings);
    EXPECT_EQ(executor.plan().steps.size(), 1U) << rendered.explanation; // finish
    double worst = 0;
    for (std::size_t at = 0; at < texels.size(); at += 4) {
        const lutlib::RgbD exact = lutlib::Transform::of(steep, lutlib::Interpolation::trilinear)(
            {static_cast<double>(texels[at]), static_cast<double>(texels[at + 1]),
             static_cast<double>(texels[at + 2])});
        for (std::size_t c = 0; c < 3; ++c) {
            worst = std::max(worst, std::abs(rendered.rgba[at + c] - 255 * exact[c]));
        }
    }
    EXPECT_LE(worst, 0.501);
}

TEST_F(FrameTest, dithers_what_lies_between_codes_and_nothing_else) {
    std::vector<float> texels;
    for (std::uint32_t i = 0; i < size.width * size.height; ++i) {
        texels.insert(texels.end(), {100.3F / 255, static_cast<float>(i % 256) / 255, 0, 1});
    }
    const GpuPicture picture(device(), size, texels, true);
    FrameInputs inputs;
    inputs.picture = &picture;
    FrameSettings settings = settings_for({});
    settings.effects.clear();
    settings.dithers = true;
    Executor executor(device());
    const Rendered rendered = render_frame(executor, inputs, settings);
    double sum = 0;
    for (std::size_t at = 0; at < texels.size(); at += 4) {
        sum += rendered.rgba[at];
        ASSERT_TRUE(rendered.rgba[at] == 100 || rendered.rgba[at] == 101);
        ASSERT_EQ(rendered.rgba[at + 1], at / 4 % 256);
    }
    EXPECT_NEAR(sum / (size.width * size.height), 100.3, 0.01);
}

TEST_F(FrameTest, codes_that_are_exposed_are_not_measured_for_a_bloom_that_there_is_not) {
    std::vector<float> texels;
    for (std::uint32_t i = 0; i < size.width * size.height; ++i) {
        texels.insert(texels.end(), {static_cast<float>(i % 256) / 255, 0.5F, 0.25F, 1});
    }
    const GpuPicture picture(device(), size, texels, true);
    FrameInputs inputs;
    inputs.picture = &picture;
    FrameSettings settings = settings_for({});
    settings.effects.clear();
    settings.exposure = -1;
    Executor executor(device());
    const Rendered rendered = render_frame(executor, inputs, settings);
    EXPECT_EQ(executor.plan().steps.size(), 2U) << rendered.explanation; // resolve, finish
    EXPECT_NE(rendered.explanation.find("nothing blooms"), std::string::npos);
    settings.force_all = true;
    const Rendered forced = render_frame(executor, inputs, settings);
    EXPECT_EQ(executor.plan().steps.size(), 3U) << forced.explanation; // clear
    EXPECT_EQ(rendered.rgba, forced.rgba);
}

TEST_F(FrameTest, a_look_whose_channels_do_not_mix_is_looked_up_in_its_curves_and_says_so) {
    lutlib::Lut look;
    look.cube = lutlib::identity_cube(9);
    for (lutlib::Rgb& node : look.cube->nodes) {
        node = {std::sqrt(node.r), 1 - node.g * node.g, node.b * 0.5F};
    }
    const GpuLookup& lookup = *gpu_lookup_named("tetrahedral");
    const GpuLook curves(device(), look_for(look, lookup).data);
    const GpuLook lattice(device(), look_data(look, lookup));
    const std::vector<float> texels(std::size_t{4} * size.width * size.height, 0.3F);
    const GpuPicture picture(device(), size, texels, true);
    FrameInputs inputs;
    inputs.picture = &picture;
    FrameSettings settings = settings_for({});
    settings.effects.clear();
    Executor executor(device());
    inputs.look_a = &lattice;
    const Rendered wanted = render_frame(executor, inputs, settings);
    EXPECT_EQ(wanted.explanation.find("lattice of look A"), std::string::npos);
    inputs.look_a = &curves;
    const Rendered got = render_frame(executor, inputs, settings);
    EXPECT_NE(got.explanation.find("lattice of look A"), std::string::npos) << got.explanation;
    EXPECT_EQ(got.rgba, wanted.rgba);
}

TEST_F(FrameTest, a_picture_leaves_out_all_that_comes_before_the_resolve) {
    const std::vector<float> texels(std::size_t{4} * size.width * size.height, 0.25F);
    const GpuPicture picture(device(), size, texels, false);
    FrameInputs inputs;
    inputs.picture = &picture;
    FrameSettings settings = settings_for({});
    settings.effects.clear();
    settings.keep_hdr = true;
    Executor executor(device());
    const Rendered rendered = render_frame(executor, inputs, settings);
    EXPECT_EQ(executor.plan().steps.size(), 3U) << rendered.explanation; // clear, resolve, finish
    for (std::size_t at = 0; at < rendered.hdr.size(); at += 4) {
        ASSERT_EQ(rendered.hdr[at], 0.25F);
    }
    settings.exposure = 2;
    EXPECT_EQ(render_frame(executor, inputs, settings).hdr[0], 1.0F);
}

} // namespace
} // namespace preview
