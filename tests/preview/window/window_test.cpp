// The window as a person uses it: real mouse and key events on a virtual X server, and a look at
// its screen.
#include "tests/preview/scene/gltf_writer.h"
#include "tests/preview/window/window_fixture.h"

namespace desktop {
namespace {

namespace fs = std::filesystem;

TEST_F(Window, edits_a_look_that_was_opened_undoes_and_exports_strips_that_verify) {
    start_unsized({"--size", "800x530", "plain"}); // shows the curve
    click("tab.Files");
    const Screen plain = first_screen();
    open("look.cube");
    const Screen opened =
        screen_where([&](const Screen& now) { return now.changed(plain, between(0.5, 1)) > 0.5; },
                     "the look on side B");
    EXPECT_EQ(opened.changed(plain, between(0, 0.5)), 0) << "side A shows it too";

    export_by("export-strip");
    EXPECT_EQ(verify("look-piccolo.png", "look.cube"), 0);

    click("tab.Look");
    click("add");
    click("add.hue-vs-sat");
    const Area curve = place("op0.curve");
    const Area upper{curve.x, curve.y, curve.width, curve.height / 2}; // the rest may be below
    const Screen neutral = screen_where(
        [&](const Screen& now) { return now.changed(opened, upper) > 0.5; }, "the curve");
    EXPECT_EQ(neutral.changed(opened, picture()), 0) << "a neutral operator changes the picture";

    drag(curve.at(0.1, 0.5), curve.at(0.1, 0.3), curve.at(0.1, 0.05));
    const Screen edited = screen_where(
        [&](const Screen& now) { return now.changed(neutral, between(0.5, 1)) > 0.01; },
        "what the knot does");
    EXPECT_EQ(edited.changed(neutral, between(0, 0.5)), 0);

    const Area all = picture();
    drag(all.at(0.5, 0.3), all.at(0.4, 0.3), all.at(0.25, 0.3));
    const Screen moved = screen_where(
        [&](const Screen& now) { return now.changed(edited, between(0.25, 0.5)) > 0.5; },
        "the split line's way");
    EXPECT_EQ(moved.changed(edited, between(0, 0.25)), 0);
    EXPECT_EQ(moved.changed(edited, between(0.5, 1)), 0);

    key("ctrl+z");
    screen_where(is(edited), "the split line where it was");
    key("ctrl+z");
    screen_where(is(neutral), "the curve without the knot");
    key("ctrl+y");
    screen_where(is(edited), "the knot again");

    click("tab.Files");
    click("save");
    ASSERT_TRUE(fs::exists(file("look.json")));
    begin_export("export-strip");
    click("export.cancel");
    EXPECT_EQ(verify("look-piccolo.png", "look.cube"), 0) << "the strip was not kept";
    begin_export("export-strip");
    key("Escape");
    EXPECT_EQ(verify("look-piccolo.png", "look.cube"), 0) << "the strip was not kept";
    export_by("export-strip");
    EXPECT_EQ(verify("look-piccolo.png", "look.cube"), 1) << "the knot is not in the strip";
    ASSERT_EQ(say({LUTCONV, "bake", "look.json", "-o", "baked.png"}, desktop_->folder()).code, 0);
    EXPECT_EQ(contents("look-piccolo.png"), contents("baked.png"));
}

TEST_F(Window, lists_its_keys_on_f1_until_escape) {
    start({"picture.ppm"});
    const Screen before = first_screen();
    key("F1");
    const Area help = place("help");
    const Screen helped = screen_where(
        [&](const Screen& now) { return now.changed(before, help) > 0.5; }, "the help");
    const Area panels = place("panels");
    const int below = help.y + help.height;
    EXPECT_EQ(helped.changed(before, {panels.x, below, panels.width, panels.height - below}), 0);
    key("Escape");
    screen_where(is(before), "the picture without the help");
}

TEST_F(Window, takes_letters_for_a_text_field_and_f1_for_help_while_one_is_typed_in) {
    start({"picture.ppm", "--b", "look.cube"});
    click("tab.Files");
    click("open.path");
    const Screen split = first_screen();
    type("1b2a");
    const Screen typed = screen_where(
        [&](const Screen& now) { return now.changed(split, place("open.path")) > 0; }, "the text");
    EXPECT_EQ(typed.changed(split, picture()), 0) << "a letter was a shortcut";
    key("F1");
    place("help");
}

TEST_F(Window, shows_one_side_while_its_key_is_held_and_other_comparisons_by_key) {
    start({"picture.ppm", "--b", "look.cube"});
    const Screen split = first_screen();
    key("F2");
    const Screen a = screen_where(
        [&](const Screen& now) { return now.changed(split, between(0.5, 1)) > 0.5; }, "side A");
    EXPECT_EQ(a.changed(split, between(0, 0.5)), 0);
    key("F3");
    const Screen b =
        screen_where([&](const Screen& now) { return now.changed(a, picture()) > 0.5; }, "side B");
    EXPECT_EQ(b.changed(split, between(0.5, 1)), 0);
    act({"keydown", "a"});
    screen_where(is(a), "side A while A is held");
    act({"keyup", "a"});
    screen_where(is(b), "side B again");
    key("F4");
    screen_where(is(split), "both sides");
}

TEST_F(Window, follows_its_size_and_draws_nothing_while_it_is_not_seen) {
    start({"plain"});
    first_screen();
    const int panels = place("panels").width;
    const auto resize = [&](int width, int height) {
        desktop_->xdotool({"search", "--name", "lutpreview", "windowsize", std::to_string(width),
                           std::to_string(height)});
        wait_until(
            [&] {
                const Area now = place("panels");
                return now.x + now.width == width && now.height == height;
            },
            "the window's new size");
    };
    resize(900, 540);
    EXPECT_EQ(place("panels").width, panels);
    act({"click", "3"});
    EXPECT_GT(picture().y + picture().height, 480);
    screen_where([&](const Screen& now) { return now.changed(black(), picture()) == 1; },
                 "the picture in the new rows");
    resize(640, 200);
    resize(800, 480);
    act({"click", "3"});
    const Screen before = first_screen();

    desktop_->xdotool({"search", "--name", "lutpreview", "windowunmap"});
    screen_where([&](const Screen& now) { return now.changed(before, picture()) == 1; },
                 "the desktop without the window");
    rest();
    const int last = frame();
    desktop_->xdotool({"mousemove", "100", "100", "mousemove", "300", "200"});
    rest();
    EXPECT_EQ(frame(), last);
    desktop_->xdotool({"search", "--name", "lutpreview", "windowmap"});
    act({"click", "3"});
    screen_where(is(before), "the window again");
}

TEST_F(Window, shows_a_picture_in_its_own_proportions) {
    gradient(200, 100).write(file("wide.ppm"));
    start({"wide.ppm", "--b", "look.cube"});
    first_screen();
    const Area wide = place("picture");
    EXPECT_EQ(wide.width, 2 * wide.height);
    const Screen before = desktop_->grab();
    const auto is_surround = [&](const Area& area) {
        Screen grey = black();
        for (std::uint32_t& pixel : grey.pixels) {
            pixel = (before.pixels[0] & 0xff000000) | 0x2e2e2e;
        }
        return before.changed(grey, area) == 0;
    };
    EXPECT_TRUE(is_surround({100, wide.y - 10, 100, 10}));
    EXPECT_FALSE(is_surround({100, wide.y, 100, wide.height}));
    EXPECT_TRUE(is_surround({100, wide.y + wide.height, 100, 10}));
    key("F5");
    // A height that half of such a width asks for may lie between two rows.
    EXPECT_NEAR(place("picture").width, 4 * place("picture").height, 2);
    // The split line is where the mouse is in the picture.
    key("F4");
    const Screen split = first_screen();
    drag(wide.at(0.5, 0.8), wide.at(0.4, 0.8), wide.at(0.25, 0.8));
    const Screen moved = screen_where(
        [&](const Screen& now) { return now.changed(split, between(0.25, 0.5)) > 0.5; },
        "the split line's way");
    EXPECT_EQ(moved.changed(split, between(0, 0.25)), 0);
}

TEST_F(Window, shows_what_is_wrong_with_a_file_and_changes_nothing_else) {
    std::ofstream(file("bad.cube")) << "LUT_3D_SIZE 2\n0 0 0\n1 zero 0\n";
    start({"picture.ppm", "--b", "look.cube"});
    click("tab.Files");
    const Screen before = first_screen();
    for (const std::string name : {"bad.cube", "absent.cube"}) {
        open(name);
        const Area error = place("error");
        screen_where([&](const Screen& now) { return now.changed(before, error) > 0.5; },
                     "the error of " + name);
        if (name == "bad.cube") {
            click("error.close");
        } else {
            key("Escape");
        }
        screen_where(is(before), "the same picture");
    }
    // Nothing changed that could be undone.
    key("ctrl+z");
    screen_where(is(before), "the same picture");
    export_by("export-strip");
    EXPECT_EQ(verify("look-piccolo.png", "look.cube"), 0);
}

TEST_F(Window, rests_while_nothing_changes_and_wakes_with_the_mouse) {
    start({"picture.ppm"});
    first_screen();
    rest();
    const int last = frame();
    rest();
    EXPECT_EQ(frame(), last);
    act(mouse_to({200, 200}));
    EXPECT_GT(frame(), last);
}

TEST_F(Window, keeps_everything_when_all_of_it_on_the_gpu_is_made_anew) {
    start({"picture.ppm", "--b", "look.cube"});
    click("tab.View");
    click("sideA.source");
    const Screen before = first_screen();
    key("ctrl+shift+r");
    screen_where(is(before), "the same picture");
    key("ctrl+z");
    screen_where([&](const Screen& now) { return now.changed(before, between(0, 0.5)) > 0.9; },
                 "side A without its look");
    key("ctrl+y");
    screen_where(is(before), "the same picture");
}

TEST_F(Window, does_with_a_built_in_font_where_one_is_missing_and_says_so) {
    std::ofstream(file("no-font.ttf")) << "not a font";
    start({"picture.ppm", "--font", "no-font.ttf"});
    const Screen told = first_screen();
    click("error.close");
    screen_where([&](const Screen& now) { return now.changed(told, picture()) > 0.05; },
                 "the message closed");
    EXPECT_EQ(places().count("error.close"), 0U);
}

TEST_F(Window, switches_effects_and_lights_and_brings_them_back) {
    start({"studio"});
    const Screen before = first_screen();
    click("tab.Scene");
    click("light.key.on");
    const Screen dark = screen_where(
        [&](const Screen& now) { return now.changed(before, picture()) > 0.9; }, "less light");
    click("light.key.size"); // a ball has none: nothing that could be undone
    click("tab.Passes");
    click("effect.bloom");
    screen_where([&](const Screen& now) { return now.changed(dark, picture()) > 0.05; },
                 "no bloom");
    key("ctrl+z");
    screen_where(is(dark), "bloom");
    key("ctrl+z");
    screen_where(is(before), "the light");
}

TEST_F(Window, shows_a_look_on_a_picture_of_another_encoding_that_is_found_by_typing) {
    // Half of LogC3's code, shown as it is.
    std::ofstream(file("log.cube")) << "# Input encoding: logc3/rec709\n# Output encoding: srgb\n"
                                       "LUT_1D_SIZE 2\n0 0 0\n0.5 0.5 0.5\n";
    start({"picture.ppm", "--b", "log.cube", "--picture-encoding", "logc3/rec709"});
    const Screen log = first_screen();
    const auto blue = [&](const Screen& screen, double across) {
        const Point at = picture().at(across, 0.5);
        return static_cast<int>(
            screen.pixels[static_cast<std::size_t>(at.y * screen.width + at.x)] & 0xff);
    };
    EXPECT_NEAR(blue(log, 0.25), 128, 1);
    EXPECT_NEAR(blue(log, 0.75), 64, 1);

    click("tab.Look");
    click("look.encodings");
    click("look.picture.curve");
    type("srgb");
    click("look.picture.curve.srgb");
    const Screen srgb = screen_where(
        [&](const Screen& now) { return now.changed(log, between(0.5, 1)) > 0.5; }, "sRGB codes");
    EXPECT_EQ(srgb.changed(log, between(0, 0.5)), 0) << "side A has no look";
    // LogC3 of the light of sRGB's 128/255 is 0.4096 (ARRI's formula, EI 800).
    EXPECT_NEAR(blue(srgb, 0.75), 0.5 * 0.4096 * 255, 1);
    key("ctrl+z");
    screen_where(is(log), "LogC3 codes again");
}

TEST_F(Window, opens_a_model_with_its_lights_and_undoes_that) {
    preview::GltfWriter gltf;
    gltf.add("materials", {{"emissiveFactor", {1, 0, 1}}, {"doubleSided", true}});
    gltf.add_node({{"mesh", gltf.add_mesh(preview::square_corners())}});
    gltf.write(file("model.gltf"));
    std::ofstream(file("broken.glb")) << "glTF";
    start({"plain", "--raster", "compute"});
    const Screen before = first_screen();
    open("model.gltf");
    const Screen model = screen_where(
        [&](const Screen& now) { return now.changed(before, picture()) > 0.5; }, "the model");
    open("broken.glb");
    click("error.close");
    screen_where(is(model), "the model still");
    key("ctrl+z");
    screen_where(is(before), "the scene");
    key("ctrl+y");
    screen_where(is(model), "the model again");
}

TEST_F(Window, computes_the_scene_again_only_when_it_changes) {
    start({"plain"});
    first_screen();
    rest();
    const auto cost_of = [&](const std::function<void()>& gesture) {
        const auto before = program_->processor_time();
        for (int i = 0; i < 4; ++i) {
            gesture();
        }
        rest();
        return program_->processor_time() - before;
    };
    const Area panels = place("panels"), all = picture();
    const auto turning =
        cost_of([&] { drag(all.at(0.2, 0.5), all.at(0.25, 0.5), all.at(0.3, 0.5)); });
    rests_ = {panels.at(0.5, 0.9), panels.at(0.5, 0.8)};
    act(mouse_to(rests_[0]));
    const auto hovering = cost_of([&] { act(mouse_to(panels.at(0.5, 0.7))); });
    EXPECT_LT(2 * hovering, turning);
}

TEST_F(Window, remembers_how_wide_its_panels_are) {
    start({"picture.ppm"});
    const Area before = place("panels");
    drag({before.x, 300}, {before.x + 10, 300}, {before.x + 40, 300});
    const Area dragged = place("panels");
    EXPECT_NEAR(dragged.width, before.width - 40, 3);
    quit();
    start({"picture.ppm"});
    EXPECT_EQ(place("panels").width, dragged.width);
}

class NoDisplay : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "lutpreview_no_display_XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }

    Said say_without(const Words& arguments) const {
        return say(Words{"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", LUTPREVIEW} + arguments,
                   folder_);
    }
    fs::path folder_;
};

TEST_F(NoDisplay, is_said_plainly_where_a_window_was_asked_for) {
    const Said said = say_without({"plain"});
    EXPECT_EQ(said.code, 2);
    EXPECT_NE(said.text.find("cannot open a window"), std::string::npos) << said.text;
    EXPECT_NE(said.text.find("--headless"), std::string::npos) << said.text;
}

TEST_F(NoDisplay, is_needed_for_nothing_headless) {
    const Said said = say_without({"plain", "--headless", "--size", "64x36", "-o", "out.png"});
    EXPECT_EQ(said.code, 0) << said.text;
    EXPECT_TRUE(fs::exists(folder_ / "out.png"));
}

} // namespace
} // namespace desktop
