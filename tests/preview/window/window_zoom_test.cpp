// Pixels of a picture and a scene seen larger, by wheel, keys, mouse and panel.
#include "tests/preview/window/window_fixture.h"

namespace desktop {
namespace {

class WindowZoom : public Window {
  protected:
    static std::uint32_t at(const Screen& screen, Point point) {
        return screen.pixels[static_cast<std::size_t>(point.y * screen.width + point.x)] & 0xffffff;
    }
};

TEST_F(WindowZoom, shows_a_pictures_own_pixels_which_the_mouse_carries) {
    gradient(1600, 1200).write(file("large.ppm"));
    start({"large.ppm"});
    const Screen all = first_screen();
    const Area room = place("picture");
    act(mouse_to(room.at(0.5, 0.5)) + Words{"key", "z"});
    const Screen own =
        screen_where([&](const Screen& now) { return now.changed(all, picture()) > 0.9; }, "1:1");
    const Area seen = place("picture");
    EXPECT_GT(seen.height, room.height) << "a part fills the room";
    // Red grows by 255 over 1600 columns.
    const auto red = [&](const Screen& screen, double across) {
        return static_cast<double>(at(screen, seen.at(across, 0.5)) >> 16);
    };
    EXPECT_NEAR(red(own, 0.9) - red(own, 0.1), 0.8 * seen.width * 255 / 1600, 2);
    drag(seen.at(0.7, 0.5), seen.at(0.6, 0.5), seen.at(0.2, 0.5));
    const Screen carried = screen_where(
        [&](const Screen& now) { return now.changed(own, picture()) > 0.9; }, "another part");
    EXPECT_NEAR(red(carried, 0.2), red(own, 0.7), 1);
    key("ctrl+z");
    screen_where(is(own), "the first part");
    act(mouse_to(seen.at(0.5, 0.5)) + Words{"click", "4", "click", "4", "click", "4"});
    const Screen larger = screen_where(
        [&](const Screen& now) { return now.changed(own, picture()) > 0.5; }, "larger pixels");
    EXPECT_NEAR(red(larger, 0.5), red(own, 0.5), 1) << "what is under the mouse stays";
    key("z");
    screen_where(is(all), "all of it");
}

TEST_F(WindowZoom, shows_squares_or_what_is_between_them) {
    gradient(40, 30).write(file("small.ppm"));
    start({"small.ppm"});
    key("F2"); // without the line of a comparison
    first_screen();
    click("tab.View");
    click("zoom.8:1");
    const Area seen = place("picture");
    const auto steps = [&](const Screen& screen) {
        int out = 0;
        for (int x = seen.x + 1; x < seen.x + seen.width; ++x) {
            out += at(screen, {x, seen.y + seen.height / 2}) !=
                           at(screen, {x - 1, seen.y + seen.height / 2})
                       ? 1
                       : 0;
        }
        return out;
    };
    // 40 columns of 8 pixels, and the surround at both sides.
    const Screen squares =
        screen_where([&](const Screen& now) { return steps(now) == 41; }, "squares");
    EXPECT_EQ(at(squares, {seen.x + 2, seen.y + 100}), 0x2e2e2eU);
    key("ctrl+p");
    type("magnified smooth");
    key("Return");
    screen_where([&](const Screen& now) { return steps(now) > 100; }, "what is between");
    EXPECT_EQ(places().count("setting.zoom"), 1U);
}

TEST_F(WindowZoom, of_a_scene_is_with_ctrl_and_leaves_the_camera) {
    start({"plain"});
    const Screen all = first_screen();
    const Area room = picture();
    act(mouse_to(room.at(0.5, 0.5)) +
        Words{"keydown", "ctrl", "click", "4", "click", "4", "keyup", "ctrl"});
    screen_where([&](const Screen& now) { return now.changed(all, picture()) > 0.1; },
                 "larger pixels");
    key("z");
    screen_where(is(all), "the scene as it was: Ctrl counts when the wheel turns");
    act(mouse_to(room.at(0.5, 0.5)) + Words{"click", "5"});
    screen_where([&](const Screen& now) { return now.changed(all, picture()) > 0.1; },
                 "the camera farther");
}

} // namespace
} // namespace desktop
