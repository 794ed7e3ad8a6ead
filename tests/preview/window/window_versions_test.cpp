// Versions of the look by their keys and in their panel.
#include "tests/preview/window/window_fixture.h"

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

} // namespace
} // namespace desktop
