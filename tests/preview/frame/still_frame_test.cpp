// A frame that compares its picture with a reference still.
#include "preview/finish/fit.h"
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "tests/preview/frame/frame_fixture.h"

#include <array>

namespace preview {
namespace {

/// Eight-bit codes that no scene has by chance.
std::vector<float> pattern(Size size) {
    std::vector<float> out;
    for (std::uint32_t i = 0; i < size.width * size.height; ++i) {
        out.insert(out.end(),
                   {static_cast<float>(37 * i % 256) / 255, static_cast<float>(11 * i % 256) / 255,
                    static_cast<float>(i / size.width % 256) / 255, 1});
    }
    return out;
}

class StillFrame : public FrameTest {
  protected:
    using Code = std::array<int, 3>;
    static Code code_at(const Rendered& rendered, std::uint32_t x, std::uint32_t y) {
        const std::size_t at = 4 * (std::size_t{y} * rendered.size.width + x);
        return {rendered.rgba[at], rendered.rgba[at + 1], rendered.rgba[at + 2]};
    }
    static Code code_of(const std::vector<float>& rgba, Size own, std::uint32_t x,
                        std::uint32_t y) {
        Code out{};
        for (std::size_t c = 0; c < 3; ++c) {
            out[c] =
                static_cast<int>(std::lround(rgba[4 * (std::size_t{y} * own.width + x) + c] * 255));
        }
        return out;
    }
    FrameSettings finished_settings() const {
        FrameSettings settings = settings_for(loaded_.scene);
        set_usual(settings.effects, true);
        put_use(settings.effects, usual_use(*post_effect_named("vignette")));
        return settings;
    }
    Loaded loaded_{scene_at(*scene_named("studio"), 0)};
    const GpuLook look_{device(),
                        look_for(inverting_look(), *gpu_lookup_named("tetrahedral")).data};
};

// Effects are laid over the picture, and not over what is finished already.
TEST_F(StillFrame, shows_each_side_where_a_comparison_of_looks_does_and_the_still_untouched) {
    const std::vector<float> codes = pattern(size);
    const GpuPicture still(device(), size, codes, true);
    for (const std::size_t side : {0U, 1U}) {
        FrameInputs inputs = loaded_.inputs();
        (side == 0 ? inputs.look_b : inputs.look_a) = &look_;
        FrameSettings settings = finished_settings();
        Executor executor(device());
        settings.compare = side == 0 ? &compare_b : &compare_a;
        const Rendered graded = render_frame(executor, inputs, settings);
        inputs.stills[side] = &still;
        for (const Compare& compare : compares) {
            if (&compare == &compare_difference) {
                continue;
            }
            SCOPED_TRACE(std::string(compare.name) + " " + std::to_string(side));
            settings.compare = &compare;
            settings.split_angle = 30;
            settings.output = &compare == &compare_side ? Size{2 * size.width, size.height} : size;
            const Rendered shown = render_frame(executor, inputs, settings);
            ASSERT_EQ(shown.size, settings.output);
            const WipeShape shape = wipe_shape(settings, compare, size);
            int borders = 0;
            for (std::uint32_t y = 0; y < size.height; ++y) {
                for (std::uint32_t x = 0; x < settings.output.width; ++x) {
                    const bool is_a = &compare == &compare_side ? x < size.width
                                      : compare.shows_one
                                          ? shows_a(shape, compare, x + 0.5, y + 0.5)
                                          : compare.shows_a;
                    const Code got = code_at(shown, x, y);
                    const std::uint32_t column = x % size.width;
                    const Code wanted = is_a == (side == 0) ? code_of(codes, size, column, y)
                                                            : code_at(graded, column, y);
                    if (got != wanted) {
                        ASSERT_EQ(got, (Code{255, 255, 255})) << x << " " << y;
                        ++borders;
                    }
                }
            }
            EXPECT_LE(borders, compare.shows_one ? 4 * 160 : 0);
            EXPECT_EQ(borders > 20, compare.shows_one);
        }
    }
}

TEST_F(StillFrame, has_no_difference_from_itself_and_that_of_lutlib_from_another) {
    FrameInputs inputs = loaded_.inputs();
    inputs.look_b = &look_;
    FrameSettings settings = finished_settings();
    Executor executor(device());
    settings.compare = &compare_b;
    const Rendered graded = render_frame(executor, inputs, settings);
    std::vector<float> same;
    for (const std::uint8_t code : graded.rgba) {
        same.push_back(static_cast<float>(code) / 255);
    }
    const GpuPicture itself(device(), size, same, true);
    inputs.stills[0] = &itself;
    settings.compare = &compare_difference;
    const Rendered none = render_frame(executor, inputs, settings);
    ASSERT_TRUE(none.figures);
    EXPECT_LT(none.figures->max, 1e-3);
    std::vector<float> white(same.size(), 1);
    const GpuPicture other(device(), size, white, true);
    inputs.stills[0] = &other;
    const Rendered some = render_frame(executor, inputs, settings);
    ASSERT_TRUE(some.figures);
    EXPECT_GT(some.figures->mean, 5);
    EXPECT_LE(some.figures->max, 102);
}

TEST_F(StillFrame, stands_between_bars_where_it_has_other_proportions_which_do_not_differ) {
    constexpr Size own{30, 60};
    const std::vector<float> white(std::size_t{4} * own.width * own.height, 1);
    const GpuPicture still(device(), own, white, true);
    FrameInputs inputs = loaded_.inputs();
    inputs.stills[0] = &still;
    FrameSettings settings = finished_settings();
    settings.compare = &compare_a;
    Executor executor(device());
    const Rendered shown = render_frame(executor, inputs, settings);
    const Size extent = fitted(own, size);
    ASSERT_EQ(extent, (Size{45, 90}));
    for (std::uint32_t y = 0; y < size.height; ++y) {
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const bool is_in = x >= 57 && x < 57 + extent.width;
            ASSERT_EQ(code_at(shown, x, y), (is_in ? Code{255, 255, 255} : Code{46, 46, 46}))
                << x << " " << y;
        }
    }
    EXPECT_FALSE(kept(shown, "finish")) << "nobody sees the scene: " << shown.explanation;
    // The scene and a still of it, as large as the middle: only that counts.
    settings.compare = &compare_difference;
    const Rendered difference = render_frame(executor, inputs, settings);
    EXPECT_EQ(code_at(difference, 2, 40), code_at(difference, 157, 80)) << "no difference in bars";
}

TEST_F(StillFrame, is_seen_larger_viewed_and_told_as_the_picture_is) {
    const std::vector<float> codes = pattern(size);
    const GpuPicture still(device(), size, codes, true);
    FrameInputs inputs = loaded_.inputs();
    inputs.look_b = &look_;
    inputs.stills[0] = &still;
    FrameSettings settings = finished_settings();
    settings.compare = &compare_split;
    settings.probe = ProbePlace{20, 30};
    Executor executor(device());
    for (const GpuLook* const look : {inputs.look_b, static_cast<const GpuLook*>(nullptr)}) {
        FrameInputs with = inputs;
        with.look_b = look;
        const Rendered probed = render_frame(executor, with, settings);
        ASSERT_TRUE(probed.probe);
        const Codes told = codes_of(probed.probe->a);
        EXPECT_EQ((Code{told.r, told.g, told.b}), code_of(codes, size, 20, 30));
    }
    settings.probe.reset();
    settings.zoom = {.scale = 2, .x = 0, .y = 0};
    const Rendered larger = render_frame(executor, inputs, settings);
    EXPECT_EQ(code_at(larger, 41, 61), code_of(codes, size, 20, 30));
    settings.zoom = {};
    settings.picture_view = picture_view_named("red");
    const Rendered red = render_frame(executor, inputs, settings);
    const Code seen = code_at(red, 20, 60), own = code_of(codes, size, 20, 60);
    EXPECT_EQ(seen, (Code{own[0], own[0], own[0]}));
    // Without stills nothing of it is left in the frame.
    inputs.stills = {};
    EXPECT_FALSE(kept(render_frame(executor, inputs, settings), "compare with a still"));
}

// A look's slider leaves it as it was fitted.
TEST_F(StillFrame, is_fitted_once) {
    constexpr Size own{30, 60};
    const GpuPicture still(device(), own, std::vector<float>(std::size_t{4} * 30 * 60, 1), true);
    FrameInputs inputs = loaded_.inputs();
    inputs.stills[0] = &still;
    FrameSettings settings = finished_settings();
    settings.keeps_light = true;
    settings.without.set(Effect::bloom, true); // whose measuring is a frame without stills
    settings.compare = &compare_split;
    Executor executor(device());
    EXPECT_TRUE(kept(render_frame(executor, inputs, settings), "still A resolve"));
    inputs.look_b = &look_;
    const Rendered second = render_frame(executor, inputs, settings);
    EXPECT_FALSE(kept(second, "still A resolve")) << second.explanation;
    EXPECT_NE(second.explanation.find("the still and the picture's size are the same"),
              std::string::npos)
        << second.explanation;
}

} // namespace
} // namespace preview
