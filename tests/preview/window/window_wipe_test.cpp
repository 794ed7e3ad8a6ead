// The border of a comparison turned, as a box, and moved with the mouse; colours that are kept.
#include "tests/preview/window/window_fixture.h"

namespace desktop {
namespace {

class WindowWipe : public Window {
  protected:
    /// A part of the picture at these shares of it, out of the names' and the border's way.
    Area part(double left, double top, double right, double bottom) const {
        const Area all = place("picture");
        const Point from = all.at(left, top), to = all.at(right, bottom);
        return {from.x, from.y, to.x - from.x, to.y - from.y};
    }
};

TEST_F(WindowWipe, is_turned_by_a_key_and_dragged_where_it_lies) {
    start({"picture.ppm", "--b", "look.cube"});
    const Screen upright = first_screen();
    key("F2");
    const Screen a = screen_where(
        [&](const Screen& now) { return now.changed(upright, between(0.5, 1)) > 0.5; }, "side A");
    key("shift+F4");
    const Screen level = screen_where(
        [&](const Screen& now) { return now.changed(a, part(0.1, 0.7, 0.9, 0.85)) > 0.5; },
        "side B below");
    EXPECT_EQ(level.changed(a, part(0.1, 0.2, 0.9, 0.4)), 0) << "side A is above";
    const Area all = place("picture");
    drag(all.at(0.5, 0.5), all.at(0.5, 0.4), all.at(0.5, 0.25));
    const Screen moved = screen_where(
        [&](const Screen& now) { return now.changed(a, part(0.1, 0.35, 0.9, 0.45)) > 0.5; },
        "the border's way");
    EXPECT_EQ(moved.changed(a, part(0.1, 0.12, 0.9, 0.18)), 0);
    key("ctrl+z");
    screen_where(is(level), "the border where it was");
}

TEST_F(WindowWipe, is_a_box_whose_sides_are_dragged_and_which_is_drawn_anew) {
    start({"picture.ppm", "--b", "look.cube"});
    first_screen();
    key("F3");
    const Screen b = first_screen();
    key("F7");
    const Screen box = screen_where(
        [&](const Screen& now) { return now.changed(b, part(0.4, 0.4, 0.6, 0.6)) > 0.5; },
        "side A in the box");
    EXPECT_EQ(box.changed(b, part(0.1, 0.2, 0.25, 0.8)), 0);
    const Area all = place("picture");
    drag(all.at(0.7, 0.5), all.at(0.8, 0.5), all.at(0.9, 0.5));
    screen_where(
        [&](const Screen& now) { return now.changed(b, part(0.75, 0.4, 0.85, 0.6)) > 0.5; },
        "a wider box");
    act(mouse_to(all.at(0.1, 0.6)) + Words{"mousedown", "3"} + mouse_to(all.at(0.2, 0.7)) +
        mouse_to(all.at(0.3, 0.9)) + Words{"mouseup", "3"});
    const Screen drawn = screen_where(
        [&](const Screen& now) { return now.changed(b, part(0.14, 0.65, 0.26, 0.85)) > 0.5; },
        "another box");
    EXPECT_EQ(drawn.changed(b, part(0.4, 0.2, 0.9, 0.5)), 0);
}

TEST_F(WindowWipe, keeps_colours_under_the_mouse) {
    start({"picture.ppm", "--b", "look.cube"});
    first_screen();
    click("tab.Colours");
    for (const double across : {0.25, 0.75}) {
        rests_ = {place("picture").at(across, 0.5), place("picture").at(across, 0.52)};
        act(mouse_to(rests_[0]));
        rest();
        key("c");
    }
    wait_until([&] { return places().count("color.1") > 0; }, "two colours");
    click("color.forget");
    EXPECT_EQ(places().count("color.0"), 0U);
}

TEST_F(WindowWipe, goes_back_to_cameras_and_shows_intermediates_or_says_that_there_is_none) {
    start({"plain"});
    const Screen first = first_screen();
    click("tab.Scene");
    click("camera.keep");
    const Area all = picture();
    drag(all.at(0.2, 0.3), all.at(0.25, 0.35), all.at(0.35, 0.4));
    const Screen turned = screen_where(
        [&](const Screen& now) { return now.changed(first, picture()) > 0.05; }, "a turn");
    click("camera.kept.0");
    screen_where(is(first), "the camera that was kept");
    key("ctrl+z");
    screen_where(is(turned), "the turn");
    click("camera.first.0");
    screen_where(is(first), "the first camera");
    click("tab.Passes");
    click("debug-view");
    click("debug-view.normal");
    screen_where([&](const Screen& now) { return now.changed(first, picture()) > 0.5; },
                 "the normals");
    click("debug-view");
    click("debug-view.none");
    screen_where(is(first), "the picture");
    click("tab.Scene");
    drag(place("time").at(0.5, 0.5), place("time").at(0.6, 0.5), place("time").at(0.9, 0.5));
    click("time.play");
    const int playing = frame();
    wait_until([&] { return frame() > playing + 3; }, "frames of a scene that plays");
    click("time.play");
    act(mouse_to(place("time").at(0.5, 0.5)) + Words{"keydown", "ctrl", "mousedown", "1", "mouseup",
                                                     "1", "sleep", "0.5", "keyup", "ctrl"});
    key("ctrl+a");
    type("0");
    key("Return");
    screen_where(is(first), "the scene as at first");
    key("ctrl+z"); // time is no step: this takes the camera back
    screen_where(is(turned), "the turn");
    key("ctrl+y");
    screen_where(is(first), "the first camera");
    open("picture.ppm");
    const Screen shown = first_screen();
    click("tab.Passes");
    click("debug-view");
    click("debug-view.normal");
    click("error.close");
    screen_where(is(shown), "the picture, which has no normals");
    click("tab.Scene");
    click("scene.list");
    click("scene.plain");
    screen_where(is(first), "the scene by the list");
}

} // namespace
} // namespace desktop
