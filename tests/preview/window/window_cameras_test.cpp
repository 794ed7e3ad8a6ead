// Cameras that are kept in the panel Scene, by a mouse, in one window after another.
#include "tests/preview/window/window_fixture.h"

namespace desktop {
namespace {

namespace fs = std::filesystem;

class WindowCameras : public Window {
  protected:
    void right_click(const std::string& name) {
        act(mouse_to(place(name).at(0.5, 0.5)) + Words{"mousedown", "3", "mouseup", "3"});
    }
    /// What a broken file leads to is looked at here and not in TearDown.
    std::string take_log() {
        const std::string out = log();
        fs::remove(file("window.txt"));
        return out;
    }
    Screen turn(const Screen& before) {
        const Area all = picture();
        drag(all.at(0.2, 0.3), all.at(0.25, 0.35), all.at(0.35, 0.4));
        return screen_where(
            [&](const Screen& now) { return now.changed(before, picture()) > 0.05; }, "a turn");
    }
};

TEST_F(WindowCameras, are_there_in_the_next_window_of_the_same_scene_and_without_a_window) {
    start({"plain"});
    const Screen first = first_screen();
    const Screen turned = turn(first);
    click("tab.Scene");
    click("camera.name");
    type("the side");
    click("camera.keep");
    place("camera.kept.0");
    quit();

    start({"plain"});
    screen_where([&](const Screen& now) { return now.changed(first, picture()) == 0; },
                 "the first camera");
    click("tab.Scene");
    click("camera.kept.0");
    screen_where(is(turned), "the camera of the window before");
    click("scene.list");
    click("scene.studio");
    wait_until([&] { return places().count("camera.kept.0") == 0; }, "a scene without any");
    const Said said = say({LUTPREVIEW, "plain", "--camera", "the side", "--headless", "--size",
                           "64x36", "-o", "side.png"},
                          desktop_->folder());
    EXPECT_EQ(said.code, 0) << said.text;
    const Said usual =
        say({LUTPREVIEW, "plain", "--headless", "--size", "64x36", "-o", "usual.png"},
            desktop_->folder());
    EXPECT_EQ(usual.code, 0) << usual.text;
    EXPECT_NE(contents("side.png"), contents("usual.png"));
    quit();

    start({"plain", "--camera", "the side"});
    screen_where(is(turned), "the camera by its name");
    click("tab.Scene");
    right_click("camera.kept.0");
    EXPECT_EQ(places().count("camera.kept.0"), 0U);
    quit();
    EXPECT_EQ(say({LUTPREVIEW, "plain", "--camera", "the side", "--headless", "-o", "no.png"},
                  desktop_->folder())
                  .code,
              3);
}

TEST_F(WindowCameras, that_another_window_keeps_are_in_the_lists_without_a_restart) {
    start({"plain"});
    const Screen first = first_screen();
    click("tab.Scene");
    EXPECT_EQ(places().count("camera.kept.0"), 0U);
    // As another window writes them.
    fs::create_directories(file("lutpreview"));
    const std::string begin = R"({"cameras": {"plain": [{"name": "beside", "target": [0, 0, 0],)"
                              R"( "distance": 4, "azimuth": 77})";
    std::ofstream(file("lutpreview/cameras.json")) << begin + "]}}";
    act(mouse_to({120, 120}));
    wait_until([&] { return places().count("camera.kept.0") > 0; }, "the other's camera");
    click("camera.kept.0");
    const Screen beside = screen_where(
        [&](const Screen& now) { return now.changed(first, picture()) > 0.05; }, "that camera");
    click("tab.Look");
    std::ofstream(file("lutpreview/cameras.json"))
        << begin + R"(, {"name": "behind", "target": [0, 0, 0], "distance": 4, "azimuth": 180}]}})";
    key("ctrl+p");
    type("camera: behind");
    key("Return");
    screen_where([&](const Screen& now) { return now.changed(beside, picture()) > 0.05; },
                 "the camera that was kept last");
}

TEST_F(WindowCameras, of_a_broken_file_are_told_of_and_lost_nowhere) {
    fs::create_directories(file("lutpreview"));
    std::ofstream(file("lutpreview/cameras.json")) << R"({"cameras": {"plain": [)";
    start({"plain"});
    click("error.close");
    EXPECT_NE(take_log().find("cameras.json: mend or delete it"), std::string::npos);
    EXPECT_EQ(say({LUTPREVIEW, "plain", "--camera", "a", "--headless", "-o", "no.png"},
                  desktop_->folder())
                  .code,
              2);
    click("tab.Scene");
    click("camera.keep");
    EXPECT_EQ(places().count("error.close"), 0U);
    place("camera.kept.0");
    EXPECT_EQ(contents("lutpreview/cameras.json.broken"), R"({"cameras": {"plain": [)");
    quit();
    start({"plain"});
    EXPECT_EQ(places().count("error.close"), 0U);
    click("tab.Scene");
    place("camera.kept.0");
}

} // namespace
} // namespace desktop
