// The command line as settings of the frame, and what it lists.
#include "lutlib/error.h"
#include "preview/cli/look_options.h"
#include "preview/cli/option_rows.h"
#include "preview/effects/effect.h"
#include "preview/frame/frame.h"
#include "preview/look/cube_settings.h"
#include "preview/look/gpu_lookups.h"
#include "preview/scene/light_controls.h"
#include "tests/preview/cli/parsed.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

namespace preview {
namespace {

/// Whether that throws what is no mistake of the command line.
bool is_bad_input(const std::function<void()>& action) {
    try {
        action();
    } catch (const lutlib::UsageError&) {
        return false;
    } catch (const lutlib::Error&) {
        return true;
    }
    return false;
}

constexpr Size picture{400, 200};

std::vector<NamedCamera> none_kept(const std::string&) {
    return {};
}

TEST(Options, without_any_are_the_settings_defaults_with_the_usual_effects) {
    const FrameSettings usual = settings("");
    PictureSettings expected;
    set_usual(expected.effects, true);
    EXPECT_TRUE(static_cast<const PictureSettings&>(usual) == expected);
    EXPECT_EQ(usual.output, (Size{1280, 720}));
    EXPECT_EQ(usual.shadow_size, 0U); // the scene's own
    EXPECT_FALSE(usual.shows_intermediate());
}

TEST(Options, a_scene_has_its_own_finish_until_one_is_asked_for) {
    const auto of = [](const std::string& input, const std::string& arguments) {
        Options options = parsed(arguments);
        options.input = input;
        return settings_of(options, {});
    };
    const PictureSettings usual;
    EXPECT_EQ(of("studio", "").tonemap, usual.tonemap);
    EXPECT_EQ(of("chart", "").tonemap, tonemap_named("none"));
    EXPECT_EQ(of("chart", "").bloom, bloom_named("none"));
    EXPECT_EQ(of("chart", "--tonemap agx").tonemap, tonemap_named("agx"));
    EXPECT_EQ(of("chart", "--bloom glare").bloom, bloom_named("glare"));
    for (const SceneInfo& info : scenes()) {
        EXPECT_NE(of(std::string(info.name), "").tonemap, nullptr) << info.name;
        EXPECT_NE(of(std::string(info.name), "").bloom, nullptr) << info.name;
    }
}

TEST(Options, move_the_scenes_camera_by_every_number) {
    const Scene scene = scene_at(scenes().front(), 0);
    for (const NumberRow<Orbit>& row : camera_numbers()) {
        const std::string flag = "--" + std::string(row.flag);
        for (const NumberRow<Orbit>& other : camera_numbers()) {
            EXPECT_EQ(other.value(orbit_of(parsed(flag + " 0.5"), scene, &none_kept)),
                      other.value(scene.orbit) + (&other == &row ? 0.5F : 0))
                << flag << ' ' << other.flag;
        }
        const std::string beyond = std::to_string(row.max - row.min + 1);
        EXPECT_THROW(parsed(flag + "=" + beyond), CLI::ValidationError) << flag;
        EXPECT_THROW(parsed(flag + "=-" + beyond), CLI::ValidationError) << flag;
        EXPECT_GE(row.value(scene.orbit), static_cast<float>(row.min)) << flag;
        EXPECT_LE(row.value(scene.orbit), static_cast<float>(row.max)) << flag;
    }
}

TEST(Options, name_a_camera_of_the_scene_or_one_that_was_kept_of_it) {
    Scene scene = scene_at(scenes().front(), 0);
    scene.cameras = {{"own", {.distance = 3}}, {"both", {.distance = 4}}};
    const auto kept = [](const std::string& input) {
        return input == "model.glb" ? std::vector<NamedCamera>{{"both", {.distance = 5}},
                                                               {"kept 1", {.distance = 6}}}
                                    : std::vector<NamedCamera>{};
    };
    const auto distance = [&](const std::string& name, const std::string& input) {
        Options options = parsed("");
        options.camera_name = name;
        options.input = input;
        return orbit_of(options, scene, kept).distance;
    };
    EXPECT_EQ(distance("own", "model.glb"), 3);
    EXPECT_EQ(distance("both", "model.glb"), 4) << "the file's own first";
    EXPECT_EQ(distance("kept 1", "model.glb"), 6);
    EXPECT_THROW(distance("kept 1", "other.glb"), lutlib::UsageError);
    try {
        distance("kept 2", "model.glb");
        ADD_FAILURE() << "there is none";
    } catch (const lutlib::UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("kept 1"), std::string::npos) << error.what();
    }
}

TEST(Options, surround_the_scene_by_every_number_and_kind) {
    Scene scene = scene_at(scenes().front(), 0);
    scene.surroundings.sky.turbidity = 7;
    EXPECT_EQ(surroundings_of(parsed(""), scene), scene.surroundings);
    for (const NumberRow<Surroundings>& row : surroundings_numbers()) {
        const std::string flag = "--" + std::string(row.flag);
        for (const NumberRow<Surroundings>& other : surroundings_numbers()) {
            EXPECT_EQ(
                other.value(surroundings_of(parsed(flag + " " + std::to_string(row.max)), scene)),
                &other == &row ? static_cast<float>(row.max) : other.value(scene.surroundings))
                << flag << ' ' << other.flag;
        }
        EXPECT_THROW(parsed(flag + "=" + std::to_string(row.max + 1)), CLI::ValidationError);
        EXPECT_THROW(parsed(flag + " nan"), CLI::ValidationError);
    }
    EXPECT_EQ(surroundings_of(parsed("--surroundings sky"), scene).kind, SurroundingsKind::sky);
    EXPECT_EQ(surroundings_file(parsed("--surroundings sky")), "");
    const Options file = parsed("--surroundings room.exr");
    EXPECT_EQ(surroundings_of(file, scene).kind, SurroundingsKind::picture);
    EXPECT_EQ(surroundings_file(file), "room.exr");
    EXPECT_THROW(surroundings_of(parsed("--surroundings picture"), scene), lutlib::UsageError);
    EXPECT_TRUE(is_bad_input([&] { shown_of(file); })) << "there is no such file";
    EXPECT_THROW(shown_of(parsed("--surroundings skies")), lutlib::UsageError);
}

TEST(Input, that_is_named_like_a_file_and_is_none_is_no_mistake_of_usage) {
    EXPECT_TRUE(is_bad_input([] { shown_of(parsed("missing.gltf")); }));
    EXPECT_TRUE(is_bad_input([] { shown_of(parsed("folder/missing")); }));
    EXPECT_THROW(shown_of(parsed("sampel")), lutlib::UsageError);
}

TEST(Options, set_every_number_and_every_choice) {
    for (const NumberRow<PictureSettings>& row : picture_numbers()) {
        const std::string flag(row.flag);
        EXPECT_EQ(row.value(settings("--" + flag + " " + std::to_string(row.max))),
                  static_cast<float>(row.max))
            << flag;
        EXPECT_THROW(settings("--" + flag + " nan"), CLI::ValidationError) << flag;
        EXPECT_THROW(settings("--" + flag + "=" + std::to_string(row.max + 1)),
                     CLI::ValidationError)
            << flag;
    }
    for (const NumberRow<CubeView>& row : cube_numbers()) {
        const std::string flag = "--" + std::string(row.flag);
        EXPECT_EQ(row.value(parsed(flag + " " + std::to_string(row.max)).cube),
                  static_cast<float>(row.max))
            << flag;
        EXPECT_THROW(parsed(flag + "=" + std::to_string(row.max + 1)), CLI::ValidationError)
            << flag;
    }
    for (const SwitchRow<CubeView>& row : cube_switches()) {
        Options with = parsed("--" + std::string(row.flag));
        Options without = parsed("");
        EXPECT_NE(row.of(with.cube), row.of(without.cube)) << row.flag;
    }
    for (const ChoiceRow<PictureSettings>& row : picture_choices()) {
        const std::vector<Option> options = row.options();
        for (std::size_t i = 0; i < options.size(); ++i) {
            const FrameSettings chosen =
                settings("--" + std::string(row.flag) + " " + std::string(options[i].name));
            EXPECT_EQ(row.chosen(chosen), i) << row.flag;
        }
    }
}

TEST(Options, refuse_a_name_that_no_table_has_with_those_that_it_has) {
    for (const char* flag : {"compare", "tonemap", "bloom", "raster", "debug-view", "scope",
                             "scope-side", "scope-scale", "scope-gain", "effect", "without"}) {
        try {
            settings(std::string("--") + flag + " nonsense");
            ADD_FAILURE() << flag;
        } catch (const lutlib::UsageError& error) {
            EXPECT_NE(std::string(error.what()).find("'nonsense'; there are "), std::string::npos)
                << error.what();
        }
    }
}

TEST(Options, compare_a_alone_until_there_is_a_look_for_b) {
    EXPECT_EQ(settings("").compare, &compare_a);
    EXPECT_EQ(settings("--b look.cube").compare, &compare_split);
    EXPECT_EQ(settings("--b look.cube --compare diff").compare, &compare_difference);
}

TEST(Options, antialias_scenes_and_leave_pictures_alone_unless_told_otherwise) {
    const PostEffect& fxaa = *post_effect_named("fxaa");
    const auto has_fxaa = [&](const std::string& arguments, Size input) {
        return use_of(settings(arguments, input).effects, fxaa) != nullptr;
    };
    EXPECT_TRUE(has_fxaa("", {}));
    EXPECT_FALSE(has_fxaa("", picture));
    EXPECT_TRUE(has_fxaa("--fxaa", picture));
    EXPECT_FALSE(has_fxaa("--no-fxaa", {}));
    EXPECT_FALSE(has_fxaa("--without fxaa", {}));
    EXPECT_TRUE(has_fxaa("--effect fxaa:strength=0.5", picture));
}

TEST(Options, lay_effects_over_the_picture_in_their_order) {
    const FrameSettings given =
        settings("--effect vignette:strength=0.5,angle=90 --effect fxaa:strength=0.25");
    ASSERT_EQ(given.effects.size(), 2U);
    EXPECT_EQ(use_text(given.effects[0]), "fxaa:strength=0.25");
    EXPECT_EQ(use_text(given.effects[1]), "vignette:strength=0.5,angle=90");
}

TEST(Options, switch_off_every_part_of_the_frame) {
    for (const EffectInfo& row : effects) {
        const FrameSettings given = settings("--without shadows," + std::string(row.name));
        EXPECT_TRUE(given.without.has(row.effect)) << row.name;
        EXPECT_TRUE(given.without.has(Effect::shadows)) << row.name;
    }
}

TEST(Options, focus_on_a_texel_of_one_sides_picture) {
    const FrameSettings given =
        settings("--focus-at 24,12 --effect depth-of-field:aperture=4 --size 100x50");
    EXPECT_EQ(use_text(given.effects.back()),
              "depth-of-field:strength=1,focus=0,at-x=0.245,at-y=0.25,aperture=4,sensor=24,"
              "largest=40,rings=3,cell=2");
    EXPECT_EQ(settings("--focus-at 24,12 --size 100x50").effects.back().effect,
              post_effect_named("depth-of-field"));
    EXPECT_THROW(settings("--focus-at 60,12 --size 100x50 --compare side"), lutlib::UsageError);
    for (const char* const place : {"focus=3", "at-x=0.25", "at-y=0"}) {
        EXPECT_THROW(settings(std::string("--focus-at 1,1 --effect depth-of-field:") + place),
                     lutlib::UsageError)
            << place;
    }
    EXPECT_EQ(use_of(settings("--focus-at 1,1 --without depth-of-field").effects,
                     *post_effect_named("depth-of-field")),
              nullptr);
}

TEST(Options, show_every_intermediate_and_every_effect) {
    for (const DebugView& view : debug_views()) {
        EXPECT_EQ(settings("--debug-view " + std::string(view.name)).view, &view);
    }
    for (const PostEffect* effect : post_effects()) {
        const FrameSettings given = settings("--debug-view " + std::string(effect->name));
        EXPECT_EQ(given.effect_view, effect);
        EXPECT_EQ(given.view, nullptr);
    }
    EXPECT_THROW(settings("--debug-view depth --probe 1,1"), lutlib::UsageError);
}

TEST(Options, compare_a_still_with_the_other_side_unless_they_say_how) {
    EXPECT_EQ(compare_of(parsed("--still x.png")), &compare_split);
    EXPECT_EQ(compare_of(parsed("--still-b x.png --compare diff")), &compare_difference);
    EXPECT_EQ(parsed("--still-a x.png").still_a, "x.png");
    EXPECT_EQ(compare_of(parsed("")), &compare_a);
}

TEST(Options, show_a_scope_in_its_own_size_or_the_one_given) {
    const FrameSettings own = settings("--scope vectorscope --scope-side b --scope-scale linear");
    ASSERT_NE(own.scope, nullptr);
    EXPECT_EQ(own.scope_sizes[index_of(*own.scope)], (Size{own.scope->width, own.scope->height}));
    EXPECT_EQ(own.scope_side->name, "b");
    EXPECT_EQ(own.scope_logarithmic, false);
    const FrameSettings given = settings("--scope parade --scope-size 30x20");
    EXPECT_EQ(given.scope_sizes[index_of(*given.scope)], (Size{30, 20}));
    EXPECT_EQ(own.scope_region, ScopeRegion{});
    // Of a picture of 400x200, also where it is shown beside itself.
    for (const char* compare : {"a", "side"}) {
        EXPECT_EQ(settings(std::string("--scope parade --scope-region 40,50,100,150 --compare ") +
                               compare,
                           picture)
                      .scope_region,
                  (ScopeRegion{0.1F, 0.25F, 0.25F, 0.75F}));
    }
    for (const char* wrong : {"", "1", "1,2", "1,2,3", "1,2,3,4,5", "0,0,0,1", "0,0,1,0",
                              "-1,0,2,2", "300,0,101,1", "0,1,1,200", "a,b,c,d", "1,2,3,4 "}) {
        EXPECT_THROW(parse_region("--scope-region", wrong, picture), lutlib::UsageError) << wrong;
    }
}

TEST(Options, name_what_levels_of_a_scope_are_and_how_bright_counts) {
    const FrameSettings usual = settings("--scope parade");
    EXPECT_EQ(usual.scope_levels, ScopeLevels{});
    EXPECT_EQ(usual.scope_gain, &scope_gain_none);
    const FrameSettings own =
        settings("--scope parade --scope-encoding pq/p3-d65 --display-white 203 --scope-gain x4");
    EXPECT_EQ(own.scope_levels.encoding, lutlib::encoding_named("pq/p3-d65"));
    EXPECT_EQ(own.scope_levels.white, 203);
    EXPECT_EQ(own.scope_gain->factor, 4);
    EXPECT_THROW(settings("--scope parade --scope-encoding pw"), lutlib::UsageError);
    EXPECT_ANY_THROW(parsed("--display-white 20"));
}

TEST(Options, give_a_picture_its_own_size_or_its_proportions_within_the_one_given) {
    EXPECT_EQ(settings("", picture).output, picture);
    EXPECT_EQ(settings("--compare side", picture).output, (Size{800, 200}));
    EXPECT_EQ(settings("--size 100x100", picture).output, (Size{100, 50}));
    EXPECT_EQ(settings("--size 100x100 --compare side", picture).output, (Size{100, 25}));
    EXPECT_EQ(settings("--size 100x90").output, (Size{100, 90}));
}

TEST(Options, read_sizes_and_places_and_nothing_like_them) {
    EXPECT_EQ(parse_size("--size", "640x360"), (Size{640, 360}));
    for (const char* text : {"", "640", "640x", "x360", "0x1", "1x16385", "-1x5", "6x4x", "6,4"}) {
        EXPECT_THROW(parse_size("--size", text), lutlib::UsageError) << text;
    }
    const ProbePlace place = parse_place("--probe", "3,4", {10, 10});
    EXPECT_EQ(place.x, 3);
    EXPECT_EQ(place.y, 4);
    for (const char* text : {"", "3", "3,", ",4", "3,4,", "10,0", "0,10", "-1,0", "3x4"}) {
        EXPECT_THROW(parse_place("--probe", text, {10, 10}), lutlib::UsageError) << text;
    }
}

TEST(Options, every_row_sets_a_member_of_its_own) {
    Options options;
    std::set<const void*> members;
    for (const auto rows : {option_rows(), picture_option_rows()}) {
        for (const OptionRow& row : rows) {
            std::visit(
                [&](auto of) { EXPECT_TRUE(members.insert(&of(options)).second) << row.flag; },
                row.of);
        }
    }
}

TEST(EngineOptions, are_for_the_side_that_they_name_and_engine_alone_for_b) {
    const Options one = parsed("--b look.cube --engine unity");
    EXPECT_EQ(use_b(one, true).lookup, gpu_lookup_named("unity"));
    EXPECT_EQ(use_a(one, true).lookup, nullptr);
    const Options two = parsed("--a a.cube --b b.cube --engine-a godot --engine-b obs");
    EXPECT_EQ(use_a(two, true).lookup, gpu_lookup_named("godot"));
    EXPECT_EQ(use_b(two, true).lookup, gpu_lookup_named("obs"));
}

TEST(EngineOptions, take_what_people_call_an_engine_and_names_in_any_case) {
    EXPECT_EQ(use_b(parsed("--b look.cube --engine UE5"), true).lookup, gpu_lookup_named("unreal"));
    EXPECT_EQ(use_b(parsed("--b look.cube --engine Tetrahedral"), true).lookup,
              gpu_lookup_named("tetrahedral"));
    EXPECT_EQ(settings("--tonemap AgX").tonemap, tonemap_named("agx"));
}

TEST(EngineOptions, of_a_side_without_a_look_name_the_other) {
    EXPECT_THROW(use_b(parsed("--a look.cube --engine unity"), true), lutlib::UsageError);
    EXPECT_THROW(use_a(parsed("--b look.cube --engine-a unity"), true), lutlib::UsageError);
    EXPECT_THROW(use_b(parsed("--b look.cube --engine unify"), true), lutlib::UsageError);
}

TEST(EncodingOptions, are_refused_by_name) {
    const Options one = parsed("--look-input slog3 --look-input-a logc3");
    EXPECT_EQ(use_b(one, true).encodings.input, lutlib::encoding_named("slog3"));
    EXPECT_EQ(use_a(one, true).encodings.input, lutlib::encoding_named("logc3"));
    EXPECT_FALSE(use_b(parsed("--no-convert"), true).picture.convert);
    EXPECT_THROW(use_b(parsed("--look-output slog9"), true), lutlib::UsageError);
    EXPECT_THROW(use_b(parsed("--picture-encoding p9"), true), lutlib::UsageError);
}

TEST(Options, a_study_is_the_first_word_and_its_subject_the_second) {
    const Options check = parsed("check night --json");
    ASSERT_NE(check.study, nullptr);
    EXPECT_EQ(check.study->name, "check");
    EXPECT_EQ(check.input, "night");
    EXPECT_FALSE(opens_window(check));
    EXPECT_EQ(parsed("check").input, Options().input);
    EXPECT_EQ(parsed("night").study, nullptr);
    EXPECT_TRUE(opens_window(parsed("night")));
    try {
        parsed("night look.cube");
        FAIL();
    } catch (const lutlib::UsageError& error) {
        EXPECT_NE(error.message().find("'look.cube' is one word too many"), std::string::npos)
            << error.message();
    }
}

} // namespace
} // namespace preview
