// Versions of the look by their keys and in their panel.
#include "tests/preview/window/window_fixture.h"

#include <cmath>

namespace desktop {
namespace {

class WindowVersions : public Window {};

TEST_F(WindowVersions, are_stored_brought_back_and_compared_by_number_keys) {
    start_unsized({"--size", "800x530", "picture.ppm", "--b", "look.cube"}); // shows the curve
    click("tab.Look");
    const Screen look = first_screen();
    key("ctrl+1");
    click("add");
    click("add.hue-vs-sat");
    const Area curve = place("op0.curve");
    drag(curve.at(0.1, 0.5), curve.at(0.1, 0.3), curve.at(0.1, 0.05));
    const Screen edited = screen_where(
        [&](const Screen& now) { return now.changed(look, between(0.5, 1)) > 0.01; }, "the edit");
    key("1");
    screen_where(is(look), "the version");
    key("ctrl+z");
    screen_where(is(edited), "the edit again");
    key("shift+1");
    const Screen compared =
        screen_where([&](const Screen& now) { return now.changed(edited, between(0, 0.5)) > 0.5; },
                     "the version on side A");
    EXPECT_EQ(compared.changed(edited, between(0.5, 1)), 0);
    key("2"); // there is none: it says so and changes nothing
    click("error.close");
    screen_where(is(compared), "what was shown");
    click("tab.Versions");
    click("version.2.store");
    click("version.1.recall");
    screen_where([&](const Screen& now) { return now.changed(look, between(0.5, 1)) == 0; },
                 "the version by a click");
    click("version.2.recall");
    screen_where([&](const Screen& now) { return now.changed(edited, between(0.5, 1)) == 0; },
                 "the edited look by a click");
}

TEST_F(WindowVersions, have_small_pictures_that_bring_them_back) {
    start_unsized({"--size", "800x530", "picture.ppm", "--b", "look.cube"});
    const Screen look = first_screen();
    key("ctrl+1");
    click("tab.Versions");
    const auto has = [&](const std::string& name) { return places().count(name) > 0; };
    wait_until([&] { return has("picture-of.version.1"); }, "the version's picture");
    EXPECT_FALSE(has("picture-of.version.2"));
    click("tab.Look");
    click("add");
    click("add.exposure");
    drag(place("op0.stops").at(0.5, 0.5), place("op0.stops").at(0.4, 0.5),
         place("op0.stops").at(0.3, 0.5));
    const Screen darker = screen_where(
        [&](const Screen& now) { return now.changed(look, between(0.5, 1)) > 0.5; }, "the edit");
    key("ctrl+2");
    click("tab.Versions");
    wait_until([&] { return has("picture-of.version.1") && has("picture-of.version.2"); },
               "both pictures");
    rest();
    // They differ as the looks do, and change with what is stored.
    const Screen both = first_screen();
    const Area first = place("picture-of.version.1"), second = place("picture-of.version.2");
    const auto mean = [](const Screen& screen, const Area& area) {
        double sum = 0;
        for (int y = area.y; y < area.y + area.height; ++y) {
            for (int x = area.x; x < area.x + area.width; ++x) {
                sum += screen.pixels[static_cast<std::size_t>(y * screen.width + x)] >> 8 & 255;
            }
        }
        return sum / (area.width * area.height);
    };
    EXPECT_GT(mean(both, first), mean(both, second) + 20);
    click("version.1.picture");
    screen_where([&](const Screen& now) { return now.changed(look, between(0.5, 1)) == 0; },
                 "the version by a click on its picture");
    click("version.2.store");
    screen_where(
        [&](const Screen& now) { return std::abs(mean(now, first) - mean(now, second)) < 0.5; },
        "the picture of what is stored there now");
    key("ctrl+z");
    screen_where([&](const Screen& now) { return now.changed(both, second) == 0; },
                 "the picture of the one before");
}

} // namespace
} // namespace desktop
