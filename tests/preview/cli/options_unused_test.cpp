// What the program says of options that change nothing, and of what a run leaves out.
#include "lutlib/error.h"
#include "preview/cli/headless.h"
#include "preview/cli/options_unused.h"
#include "preview/effects/effect.h"
#include "preview/frame/frame.h"
#include "tests/preview/cli/parsed.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace preview {
namespace {

TEST(Options, that_change_nothing_in_a_run_are_said) {
    const auto said = [](const std::string& arguments) { return parsed(arguments).unused; };
    const std::string run = "--headless -o x.png --b look.cube ";
    for (const char* const flag :
         {"--engine-a unity", "--look-input-a srgb", "--cube-nodes 5", "--scope-size 64x64",
          "--scope-side a", "--scope-region 1,1,2,2", "--scope-gain x2", "--scope-encoding pq",
          "--display-white 203", "--scope vectorscope --scope-encoding pq",
          "--still-encoding logc3", "--frames 5", "--frame-rate 30", "--resume", "--exr picture",
          "--font x.ttf", "--watch-engine-folder x", "--heat-scale 8"}) {
        const std::vector<std::string> lines = said(run + flag);
        ASSERT_EQ(lines.size(), 1U) << flag;
        const std::string text(flag);
        const std::size_t last = text.rfind("--");
        const std::string option = text.substr(last, text.find(' ', last) - last);
        EXPECT_TRUE(lines[0].starts_with(option + " changes nothing here: ")) << lines[0];
    }
    EXPECT_EQ(said("--explain --depth float").size(), 1U);
    EXPECT_EQ(said("--quiet --verbose").size(), 2U);
    EXPECT_TRUE(said(run + "--quiet --verbose").empty());
    EXPECT_TRUE(said(run + "--engine unity --scope waveform --scope-size 64x64 --depth uint8 "
                           "--timings --frames 3")
                    .empty());
    EXPECT_TRUE(said(run + "--scope parade --scope-gain x2 --scope-encoding pq --display-white 203")
                    .empty());
    EXPECT_EQ(said("--headless -o x.csv --scope parade --scope-gain x2 --depth uint8").size(), 2U);
    EXPECT_TRUE(said("--headless -o x.##.png --frames 0-3 --frame-rate 30 --resume").empty());
    EXPECT_TRUE(said("--engine-a unity --cube-nodes 5 --font x.ttf").empty()); // in the window
}

TEST(Options, that_a_study_does_not_take_are_said) {
    EXPECT_EQ(parsed("check night -o x.png").unused.size(), 1U);
    EXPECT_EQ(parsed("check --timings --frames 3").unused.size(), 2U);
    EXPECT_TRUE(parsed("check night --b look.cube --size 64x36 --json --effect vignette --quiet")
                    .unused.empty());
    EXPECT_EQ(parsed("check --csv --budget-ms 1").unused.size(), 2U);
    EXPECT_EQ(parsed("--headless -o x.png --max-delta-e 1 --passes bloom").unused.size(), 2U);
    EXPECT_TRUE(
        parsed("report night -o x.html --csv --json --budget-ms 1 --passes bloom").unused.empty());
    EXPECT_EQ(parsed("report -o x.html --debug-view normal").unused.size(), 1U);
}

TEST(Options, that_another_option_takes_the_part_of_are_said) {
    for (const char* const arguments :
         {"--headless -o x.png --split 0.3", "--headless -o x.png --compare diff --split 0.3",
          "--headless -o x.png --picture-encoding slog3", "--headless -o x.png --no-convert",
          "--headless -o x.png --look-at before", "--effect vignette --without vignette",
          "--focus-at 1,1 --without depth-of-field", "--fxaa --without shadows,fxaa",
          "--bloom glare --without bloom", "--bloom-radius 2 --without bloom",
          "--tonemap agx --without tonemap", "--cube-view b -o x.png", "--cube-view a -o x.png",
          "--cube-view a --a look.cube --b look.cube -o x.png",
          "--cube-view b --b look.cube --engine unity --depth uint8 --json -o x.png",
          "--cube-view b --b look.cube --effect vignette --cube-nodes 5 -o x.png",
          "--exr light --scope waveform -o x.exr", "--exr picture --debug-view depth -o x.exr"}) {
        EXPECT_EQ(parsed(arguments).unused.size(), 1U) << arguments;
    }
    for (const char* const arguments :
         {"--headless -o x.png --b look.cube --split 0.3", "--split 0.3 --heat-scale 8",
          "--headless -o x.png --compare diff --heat-scale 8 --a look.cube --look-at before",
          "--effect vignette --without fxaa", "--no-fxaa --without fxaa",
          "--cube-view b --b look.cube --engine unity --look-input-b srgb --size 9x9 -o x.png",
          "--cube-view b --b look.cube -o x.png"}) {
        EXPECT_TRUE(parsed(arguments).unused.empty()) << arguments;
    }
}

TEST(Options, that_change_nothing_of_this_input_are_said) {
    Scene scene = scene_at(scenes().front(), 0);
    const auto said = [](const std::string& arguments, const KnownInput& input) {
        const Options options = parsed(arguments);
        return unused_options(options, input, settings_of(options, {})).size();
    };
    const KnownInput shows_scene{&scene, false}, shows_light{nullptr, false},
        shows_codes{nullptr, true};
    for (const SurroundingsInfo& kind : surroundings_kinds()) {
        const std::string surroundings =
            "--surroundings " +
            (kind.kind == SurroundingsKind::picture ? "x.exr" : std::string(kind.name));
        for (const NumberRow<Surroundings>& row : surroundings_numbers()) {
            const bool has_part =
                std::any_of(kind.numbers.begin(), kind.numbers.end(),
                            [&](const auto& own) { return own.flag == row.flag; });
            const std::string number = " --" + std::string(row.flag) + " 1";
            EXPECT_EQ(said(surroundings + number, shows_scene), has_part ? 0U : 1U)
                << surroundings << number;
            EXPECT_EQ(said(number, shows_light), 1U) << number;
        }
    }
    scene.floor.reset();
    EXPECT_EQ(said("--without floor", shows_scene), 1U);
    EXPECT_EQ(said("--without floor", shows_light), 1U);
    scene.floor = 0;
    EXPECT_EQ(said("--without floor", shows_scene), 0U);
    for (const char* const flag : {"--tonemap agx", "--bloom glare", "--bloom-radius 2"}) {
        EXPECT_EQ(said(flag, shows_codes), 1U) << flag;
        EXPECT_EQ(said(flag, shows_light), 0U) << flag;
    }
    EXPECT_EQ(said("--bloom none --bloom-radius 2", shows_light), 1U);
    EXPECT_EQ(said("--bloom none --bloom-radius 2", shows_codes), 2U) << "each once";
    EXPECT_EQ(said("--exr light -o x.exr", shows_codes), 1U);
    EXPECT_EQ(said("--exr picture -o x.exr", shows_codes), 0U);
    EXPECT_EQ(said("--exr light -o x.exr", shows_light), 0U);
    for (const char* const flag : {"--shadow-size 64", "--raster compute", "--azimuth 3",
                                   "--occlusion-radius 1", "--camera x", "--surroundings sky",
                                   "--shadow-filter 1x1", "--occlusion-resolution full"}) {
        EXPECT_EQ(said(flag, shows_codes), 1U) << flag;
        EXPECT_EQ(said(flag, shows_scene), 0U) << flag;
    }
}

TEST(Options, of_files_of_light_have_a_part_in_every_file_that_may_hold_it) {
    for (const char* const input : {"sample", "picture.exr"}) {
        for (const char* const output : {"x.exr", "x.hdr", "x.EXR"}) {
            EXPECT_TRUE(parsed(std::string(input) + " --exr picture -o " + output).unused.empty());
        }
        EXPECT_EQ(parsed(std::string(input) + " --exr picture -o x.tif").unused.size(), 1U);
    }
}

TEST(Options, that_a_file_of_light_has_not_are_named_with_the_remedy) {
    const auto missing = [](const std::string& arguments) {
        const Options options = parsed("-o x.exr " + arguments);
        return not_in_light(options, settings_of(options, {}));
    };
    EXPECT_EQ(missing("--b look.cube --compare side --tonemap agx --effect glitch --effect "
                      "sharpen:before-look=1"),
              "'x.exr' holds the light before bloom and tone map, without the tone map, the looks, "
              "the comparison, glitch and sharpen: add --exr picture for the finished picture");
    EXPECT_EQ(missing("--bloom-strength 0.5 --exr light"),
              "'x.exr' holds the light before bloom and tone map, without the bloom: add --exr "
              "picture for the finished picture");
    for (const PostEffect* const effect : post_effects()) {
        EXPECT_EQ(missing("--effect " + std::string(effect->name)).empty(),
                  effect->stage == Stage::hdr)
            << effect->name;
    }
    EXPECT_EQ(missing("--exposure 1 --size 8x8"), "");
    EXPECT_EQ(missing("--effect vignette --without vignette"), "");
}

TEST(Options, ask_for_parts_that_are_said_with_the_reason_that_withholds_them) {
    const Options options = parsed("--effect vignette --effect sharpen --focus-at 1,1 --dither "
                                   "--without sharpen");
    const std::vector<Withheld> withheld{{"vignette", "because"},
                                         {"sharpen", "it is not in use"},
                                         {"dither", "so"},
                                         {"depth-of-field", "it has none"},
                                         {"glitch", "it is not in use"}};
    EXPECT_EQ(left_out(asked_parts(options), withheld),
              (std::vector<std::string>{"--effect vignette changes nothing here: because",
                                        "--focus-at changes nothing here: it has none",
                                        "--dither changes nothing here: so"}));
    EXPECT_TRUE(left_out(asked_parts(options), {}).empty());
}

TEST(Views, that_a_frame_lacks_are_refused_with_the_reason) {
    const std::vector<Withheld> withheld{
        {"occlusion", "switched off"},     {"g-buffer", "surfaces are lit as they are drawn"},
        {"vignette", "it is not in use"},  {"shadow of light 0", "it casts none"},
        {"shadow of sun", "it is behind"}, {"scene", "a picture is shown"}};
    EXPECT_EQ(why_not_shown("occlusion", withheld), "switched off; drop --without occlusion");
    EXPECT_EQ(why_not_shown("vignette", withheld), "it is not in use; add --effect vignette");
    EXPECT_EQ(why_not_shown("shadows", withheld),
              "shadow of light 0: it casts none, shadow of sun: it is behind");
    EXPECT_EQ(why_not_shown("albedo", withheld),
              "g-buffer: surfaces are lit as they are drawn; drop --raster forward");
    EXPECT_EQ(why_not_shown("wireframe", withheld), "a picture is shown");
    EXPECT_EQ(why_not_shown("shadows", {{"bloom", "it is off"}, {"lights", "switched off"}}),
              "lights: switched off; drop --without lights");
    EXPECT_EQ(why_not_shown("shadows", {{"light 0", "switched off"}}), "light 0: switched off");
    EXPECT_EQ(why_not_shown("shadows", {}), "nothing in the scene makes one");
}

} // namespace
} // namespace preview
