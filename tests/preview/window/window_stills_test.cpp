// A reference still beside the picture, by dialog and by command.
#include "tests/preview/window/window_fixture.h"

#include <algorithm>
#include <limits>

namespace desktop {
namespace {

class WindowStills : public Window {
  protected:
    static Screen flat(int width, int height, std::uint32_t color) {
        return {width, height,
                std::vector<std::uint32_t>(static_cast<std::size_t>(width * height), color)};
    }
    static std::uint32_t at(const Screen& screen, Point point) {
        return screen.pixels[static_cast<std::size_t>(point.y * screen.width + point.x)] & 0xffffff;
    }
    std::function<bool(const Screen&)> left_is(std::uint32_t color) const {
        return [this, color](const Screen& now) {
            return at(now, place("picture").at(0.2, 0.5)) == color;
        };
    }
};

/// One pixel in four holds NaN, one infinity, one less than 0.
void write_odd_picture(const std::filesystem::path& path) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float inf = std::numeric_limits<float>::infinity();
    const std::array<float, 12> numbers{0.2F, 0.2F, 0.2F, nan, 1, 1, 1, inf, 1, 1, 1, -1};
    std::ofstream out(path, std::ios::binary);
    out << "PF\n2 2\n-1.0\n"; // a portable float map, little-endian
    out.write(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
}

TEST_F(WindowStills, and_surroundings_tell_which_of_their_numbers_are_no_light) {
    write_odd_picture(file("odd.pfm"));
    start({"plain", "--b", "look.cube"});
    click("tab.Versions");
    click("still.A");
    type("odd.pfm");
    key("Return");
    wait_until([&] { return places().count("still.A.told.2") > 0; }, "three kinds of numbers");
    click("tab.Scene");
    EXPECT_EQ(places().count("told.0"), 0U) << "a still is no part of the scene";
    click("tab.View");
    scroll_to("surroundings.open");
    click("surroundings.open");
    type("odd.pfm");
    key("Return");
    wait_until([&] { return places().count("surroundings.told.2") > 0; }, "the same of them");
    click("tab.Scene");
    EXPECT_EQ(places().count("told.2"), 1U);
    open("odd.pfm"); // as the picture
    click("tab.Scene");
    EXPECT_EQ(places().count("told.2"), 1U);
    EXPECT_EQ(places().count("told.3"), 0U);
}

TEST_F(WindowStills, are_opened_on_a_side_followed_converted_and_taken_off) {
    flat(400, 480, 0x204060).write(file("reference.ppm"));
    start({"picture.ppm", "--b", "look.cube"});
    const Screen before = first_screen();
    click("tab.Versions");
    click("still.A");
    type("reference.ppm");
    key("Return");
    const Screen shown = screen_where(left_is(0x204060), "the still");
    EXPECT_EQ(shown.changed(before, between(0.5, 1)), 0) << "side B is as it was";
    click("still.A.convert"); // from sRGB, which leaves it
    wait_until([&] { return places().count("still.A.curve") > 0; }, "the encoding");
    screen_where(is(shown), "the same codes");
    click("still.A.convert");
    flat(200, 480, 0x908070).write(file("reference.ppm"));
    screen_where(
        [&](const Screen& now) {
            return at(now, place("picture").at(0.4, 0.5)) == 0x908070 && left_is(0x2e2e2e)(now);
        },
        "the file as it is now, between bars");
    click("still.A.off");
    screen_where(is(before), "the picture without a look");
    key("ctrl+z");
    screen_where(
        [&](const Screen& now) { return at(now, place("picture").at(0.4, 0.5)) == 0x908070; },
        "the still");
    key("ctrl+shift+r"); // everything on the GPU is made anew
    rest();
    EXPECT_EQ(at(desktop_->grab(), place("picture").at(0.4, 0.5)), 0x908070U);
    click("tab.View");
    click("sideA.none");
    screen_where(is(before), "the picture without a look");
    click("sideA.still");
    screen_where(
        [&](const Screen& now) { return at(now, place("picture").at(0.4, 0.5)) == 0x908070; },
        "the still by the panel");
    std::ofstream(file("broken.png")) << "no picture";
    key("ctrl+p");
    type("reference still on side A");
    key("Return");
    type("broken.png");
    key("Return");
    wait_until([&] { return places().count("error.close") > 0; }, "the error");
    click("error.close");
}

TEST_F(WindowStills, that_the_gpu_has_no_room_for_are_said_and_taken_off) {
    flat(16400, 1, 0x204060).write(file("wide.ppm")); // more than software devices have
    start({"picture.ppm", "--b", "look.cube"});
    const Screen before = first_screen();
    click("tab.Versions");
    click("still.A");
    type("wide.ppm");
    key("Return");
    wait_until([&] { return places().count("error.close") > 0; }, "the reason");
    click("error.close");
    screen_where(is(before), "the picture as it was");
    EXPECT_EQ(places().count("still.A.off"), 0U);
}

TEST_F(WindowStills, are_shown_from_the_start_by_an_option) {
    flat(400, 480, 0x204060).write(file("reference.ppm"));
    start({"picture.ppm", "--still", "reference.ppm"});
    first_screen();
    screen_where(left_is(0x204060), "the still");
    const Said said = say({LUTPREVIEW, "picture.ppm", "--still", "reference.ppm", "--headless",
                           "--probe", "10,10", "-o", "out.png"},
                          desktop_->folder());
    EXPECT_EQ(said.code, 0) << said.text;
    EXPECT_NE(said.text.find("a guess"), std::string::npos) << said.text;
    EXPECT_EQ(said.text.find("to fit into"), std::string::npos) << said.text;
    EXPECT_NE(say({LUTPREVIEW, "picture.ppm", "--still", "reference.ppm", "--a", "look.cube",
                   "--headless", "-o", "out.png"},
                  desktop_->folder())
                  .code,
              0);
    EXPECT_NE(say({LUTPREVIEW, "picture.ppm", "--still", "reference.ppm", "--headless", "-o",
                   "reference.ppm"},
                  desktop_->folder())
                  .code,
              0);
}

} // namespace
} // namespace desktop
