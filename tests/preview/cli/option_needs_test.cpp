// What options need of a run: every row names it, and there are runs with and without each.
#include "preview/cli/option_needs.h"

#include "preview/cli/options_unused.h"
#include "preview/scene/scene.h"
#include "tests/preview/cli/parsed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace preview {
namespace {

/// A scene whose light casts a shadow, one whose lights cast none, a picture of light and one of
/// codes.
enum class Of : std::uint8_t { scene, shadowless, light, codes };

/// Stays where it is: the input points at the scene.
struct InputOf {
    Scene scene = scene_at(scenes().front(), 0);
    KnownInput input;

    explicit InputOf(Of of) {
        if (of == Of::shadowless) {
            for (PointLight& light : scene.lights) {
                light.casts_shadow = false;
            }
        }
        const bool is_scene = of == Of::scene || of == Of::shadowless;
        input = {is_scene ? &scene : nullptr, of == Of::codes};
    }
};

const InputOf& input_of(Of of) {
    static const InputOf inputs[] = {InputOf(Of::scene), InputOf(Of::shadowless),
                                     InputOf(Of::light), InputOf(Of::codes)};
    return inputs[static_cast<std::size_t>(of)];
}

/// A run in which a need is met and one in which it is not, both with the option, which must have
/// it.
struct Example {
    Need need;
    std::string option;
    std::string met, missing;
    Of of_met = Of::scene, of_missing = Of::scene;
};

const Example examples[] = {
    {Need::frame, "--azimuth 3", "", "--cube-view a -o x.png"},
    {Need::side_a, "--a x.cube", "", "--cube-view b -o x.png"},
    {Need::side_b, "--b x.cube", "--cube-view b -o x.png", "--cube-view a -o x.png"},
    {Need::picture, "--probe 1,1", "", "check"},
    {Need::file, "-o x.html", "report", "check"},
    {Need::listing, "--list", "", "check"},
    {Need::report, "--csv", "report", "check"},
    {Need::window, "--font x.ttf", "", "--headless -o x.png"},
    {Need::cube_view, "--cube-turn 9", "--cube-view a -o x.png", "--headless -o x.png"},
    {Need::metered_file, "--meter all", "--headless -o x.png", ""},
    {Need::terminal, "--quiet", "--headless -o x.png", ""},
    {Need::look_a, "--engine-a unity", "-o x.png --a x.cube", "-o x.png --b x.cube"},
    {Need::look_b, "--engine unity", "-o x.png --b x.cube", "-o x.png --a x.cube"},
    {Need::look, "--no-convert", "-o x.png --a x.cube", "-o x.png --a none"},
    {Need::codes, "--picture-encoding pq", "-o x.png --scope rgb --scope-encoding hlg", "-o x.png"},
    {Need::still, "--still-encoding pq", "--still-b x.png", ""},
    {Need::scope, "--scope-size 9x9", "-o x.png --scope rgb", "-o x.png"},
    {Need::scope_levels, "--scope-encoding pq", "-o x.png --scope rgb",
     "-o x.png --scope vectorscope"},
    {Need::scope_brightness, "--scope-gain x2", "-o x.png --scope rgb", "-o x.csv --scope rgb"},
    {Need::scope_encoding, "--display-white 203", "-o x.png --scope rgb --scope-encoding pq",
     "-o x.png --scope rgb"},
    {Need::frame_count, "--frames 5", "--timings", "-o x.png"},
    {Need::sequence, "--resume", "-o x.##.png --frames 0-9", "--timings --frames 9"},
    {Need::output, "--depth half", "-o x.tif", "--explain"},
    {Need::light_output, "--exr picture", "-o x.hdr", "-o x.tif"},
    {Need::whole_picture, "--zoom 2", "-o x.png", "-o x.png --debug-view depth"},
    {Need::no_scope, "--view zebra", "-o x.png", "-o x.png --scope rgb"},
    {Need::no_intermediate, "--view zebra", "-o x.png", "-o x.png --debug-view depth"},
    {Need::no_heat_map, "--view zebra", "-o x.png", "-o x.png --compare diff"},
    {Need::split, "--split 0.3", "-o x.png --b x.cube", "-o x.png --compare box"},
    {Need::box, "--box-x 0.3", "-o x.png --compare box", "-o x.png --compare split"},
    {Need::heat_map, "--heat-scale 9", "-o x.png --compare diff", "-o x.png"},
    {Need::zebra, "--zebra-level 0.5", "-o x.png --view zebra", "-o x.png"},
    {Need::zoom, "--zoom-x 0.3", "-o x.png --zoom 2", "-o x.png"},
    {Need::lights, "--light sun.on=1", "", "--without lights"},
    {Need::shadows, "--shadow-filter 1x1", "", "--without shadows"},
    {Need::occlusion, "--occlusion-radius 1", "", "--without occlusion"},
    {Need::bloom_part, "--bloom-radius 2", "", "--without bloom"},
    {Need::tonemap, "--tonemap agx", "", "--without looks,tonemap"},
    {Need::depth_of_field, "--focus-at 1,1", "", "--without depth-of-field"},
    {Need::fxaa, "--fxaa", "", "--without fxaa"},
    // A frame alone knows whether there is anything to round.
    {Need::dither, "--dither", "", ""},
    {Need::scene, "--roll 3", "", "", Of::scene, Of::light},
    {Need::surroundings_kind, "--noise-hue 9", "--surroundings noise", "--surroundings sky"},
    {Need::motion, "--time 3", "studio", "chart"},
    {Need::casting_light, "--shadow-size 99", "", "", Of::scene, Of::shadowless},
    {Need::light, "--look-at before", "--b x.cube", "--b x.cube", Of::light, Of::codes},
    {Need::light_to_write, "--exr light", "-o x.exr", "-o x.exr", Of::light, Of::codes},
    {Need::bloom, "--bloom-radius 2", "", "--bloom none"},
};

const OptionNeeds& option_of(const std::vector<OptionNeeds>& options, const std::string& given) {
    const std::string flag = given.substr(0, given.find(' '));
    const std::string name = flag == "-o" ? "--output" : flag == "--engine" ? "--engine-b" : flag;
    return *std::find_if(options.begin(), options.end(),
                         [&](const OptionNeeds& option) { return option.name == name; });
}

TEST(OptionNeeds, are_named_by_the_row_of_every_option) {
    CLI::App app;
    Options values;
    declare(app, values);
    std::set<std::string> names;
    for (const OptionNeeds& option : option_needs()) {
        EXPECT_TRUE(names.insert(option.name).second) << option.name << " has two rows";
    }
    for (const CLI::Option* const option : app.get_options()) {
        const std::vector<std::string>& long_names = option->get_lnames();
        const bool is_known =
            std::any_of(long_names.begin(), long_names.end(),
                        [&](const std::string& name) { return names.contains("--" + name); });
        EXPECT_TRUE(is_known || names.contains(option->get_name()) || option == app.get_help_ptr())
            << option->get_name();
    }
    EXPECT_EQ(names.size() + 1, app.get_options().size()) << "help has no row";
}

TEST(OptionNeeds, have_a_row_each_in_their_order_and_say_what_is_missing) {
    ASSERT_EQ(std::size(examples), static_cast<std::size_t>(Need::count));
    const std::vector<OptionNeeds> options = option_needs();
    for (std::size_t i = 0; i < std::size(examples); ++i) {
        EXPECT_EQ(need_rows()[i].need, static_cast<Need>(i));
        EXPECT_EQ(examples[i].need, static_cast<Need>(i));
        EXPECT_TRUE(std::any_of(
            options.begin(), options.end(),
            [&](const OptionNeeds& option) { return option.needs.has(static_cast<Need>(i)); }))
            << "no option needs number " << i;
    }
}

TEST(OptionNeeds, are_met_in_some_runs_and_missing_in_others) {
    const std::vector<OptionNeeds> options = option_needs();
    for (const Example& example : examples) {
        const OptionNeeds& row = option_of(options, example.option);
        ASSERT_TRUE(row.needs.has(example.need)) << example.option;
        const auto missing_in = [&](const std::string& arguments, Of of) {
            const InputOf& known = input_of(of);
            const Options run = parsed(arguments + " " + example.option);
            const FrameSettings made = settings_of(run, {});
            const NeedRow* const found =
                first_missing(row.needs, {run, row.name, &known.input, &made});
            std::vector<std::string> lines = unused_options(run);
            const std::vector<std::string> more = unused_options(run, known.input, made);
            lines.insert(lines.end(), more.begin(), more.end());
            const auto of_option =
                std::count_if(lines.begin(), lines.end(), [&](const std::string& line) {
                    return unused_option(line) == row.name;
                });
            EXPECT_EQ(of_option, found != nullptr ? 1 : 0) << arguments << ' ' << example.option;
            return found;
        };
        EXPECT_EQ(missing_in(example.met, example.of_met), nullptr)
            << example.met << ' ' << example.option;
        if (example.need == Need::dither) {
            continue;
        }
        const NeedRow* const found = missing_in(example.missing, example.of_missing);
        ASSERT_NE(found, nullptr) << example.missing << ' ' << example.option;
        EXPECT_EQ(found->need, example.need) << example.missing << ' ' << example.option;
    }
}

TEST(OptionNeeds, that_only_a_frame_knows_are_parts_of_it) {
    const auto asked = [](const std::string& arguments) {
        std::vector<std::string> out;
        for (const AskedPart& part : asked_parts(parsed(arguments))) {
            out.push_back(part.option + " of " + part.name);
        }
        return out;
    };
    using Parts = std::vector<std::string>;
    EXPECT_EQ(asked("--dither"), Parts{"--dither of dither"});
    EXPECT_EQ(asked("--no-dither --no-fxaa"), Parts{});
    EXPECT_EQ(asked("--bloom glare"), Parts{"--bloom of bloom"});
    EXPECT_EQ(asked("--bloom none"), Parts{});
    EXPECT_EQ(asked("--bloom-strength 0"), Parts{});
    EXPECT_EQ(asked("--occlusion-strength 0"), Parts{});
    EXPECT_EQ(asked("--occlusion-strength 1"), Parts{"--occlusion-strength of ambient occlusion"});
    EXPECT_EQ(asked("--tonemap agx"), Parts{"--tonemap of tone map"});
    EXPECT_EQ(asked("--tonemap agx --without tonemap"), Parts{});
}

TEST(OptionNeeds, of_parts_that_are_switched_off_are_told_too) {
    const auto said = [](const std::string& arguments, Of of) {
        const InputOf& known = input_of(of);
        const Options options = parsed("-o x.png " + arguments);
        return unused_options(options, known.input, settings_of(options, {}));
    };
    using Lines = std::vector<std::string>;
    for (const EffectInfo& part : effects) {
        const std::string option = "--without " + std::string(part.name);
        const bool is_there = part.effect != Effect::looks && part.effect != Effect::floor &&
                              part.effect != Effect::names;
        EXPECT_EQ(said(option, Of::scene).size(), is_there ? 0U : 1U) << option;
    }
    EXPECT_EQ(said("--without looks,names --b x.cube", Of::scene), Lines{});
    EXPECT_EQ(said("--without environment,tonemap", Of::codes),
              (Lines{"--without environment changes nothing here: a picture is shown",
                     "--without tonemap changes nothing here: the picture is display-encoded "
                     "already"}));
    EXPECT_EQ(said("--without shadows", Of::shadowless),
              Lines{"--without shadows changes nothing here: no light casts a shadow"});
    EXPECT_EQ(said("--without vignette", Of::scene),
              Lines{"--without vignette changes nothing here: it is not in use"});
    EXPECT_EQ(said("--without fxaa", Of::scene), Lines{});
    EXPECT_EQ(said("--without fxaa --fxaa", Of::codes), Lines{});
    EXPECT_EQ(said("--without fxaa", Of::codes).size(), 1U);
    EXPECT_EQ(said("--without vignette --effect vignette", Of::scene), Lines{}) << "said before";
}

TEST(OptionNames, are_the_longest_that_switch_on) {
    EXPECT_EQ(main_name("--engine,--engine-b"), "--engine-b");
    EXPECT_EQ(main_name("-o,--output"), "--output");
    EXPECT_EQ(main_name("--fxaa,!--no-fxaa"), "--fxaa");
    EXPECT_EQ(main_name("input"), "input");
}

TEST(OptionNeeds, of_values_are_told_by_their_tables) {
    const auto said = [](const std::string& arguments) { return parsed(arguments).unused; };
    using Lines = std::vector<std::string>;
    const std::string run = "-o x.png --effect ";
    EXPECT_EQ(said(run + "glitch:line=9,tear=0,static=0 --time 1"),
              Lines{"--effect glitch:line changes nothing here: nothing is torn, and there is no "
                    "static"});
    EXPECT_EQ(
        said(run + "glitch:rate=9"),
        Lines{"--effect glitch:rate changes nothing here: at --time 0 nothing has moved yet"});
    EXPECT_EQ(said("--effect glitch:rate=9"), Lines{}) << "a window goes on";
    EXPECT_EQ(said("-o x.##.png --frames 0-9 --effect glitch:rate=9"), Lines{});
    EXPECT_EQ(said(run + "glitch:rate=12,strength=1"), Lines{}) << "as usual";
    EXPECT_EQ(said(run + "depth-of-field:focus=2,at-x=0.1"),
              Lines{"--effect depth-of-field:at-x changes nothing here: focus says how far it is"});

    Scene scene = scene_at(scenes().front(), 0);
    scene.lights.resize(2);
    scene.lights[0].name = "sun";
    scene.lights[0].is_sun = true;
    scene.lights[1].name.clear();
    scene.lights[1].casts_shadow = false;
    const auto said_of = [&](const std::string& arguments) {
        const Options options = parsed(arguments);
        return unused_options(options, {&scene, false}, settings_of(options, {}));
    };
    EXPECT_EQ(said_of("--light sun.reach=3 --light 1.reach=3"),
              Lines{"--light sun.reach changes nothing here: a sun has no reach"});
    EXPECT_EQ(said_of("--light 1.angle=30"),
              Lines{"--light 1.angle changes nothing here: it casts no shadow"});
    EXPECT_EQ(said_of("--light 1.angle=30 --light 1.shadow=1"), Lines{});
    EXPECT_EQ(said_of("--light 1.intensity=3 --light 1.on=0"),
              Lines{"--light 1.intensity changes nothing here: it is switched off"});
    EXPECT_EQ(said_of("--light sun.shadow=1 --without shadows"),
              Lines{"--light sun.shadow changes nothing here: --without shadows switches every "
                    "shadow off"});
}

} // namespace
} // namespace preview
