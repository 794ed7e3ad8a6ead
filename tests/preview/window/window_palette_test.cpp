// The palette of commands by mouse and keys.
#include "tests/preview/window/window_fixture.h"

namespace desktop {
namespace {

class WindowPalette : public Window {};

TEST_F(WindowPalette, does_what_is_typed_and_entered_or_clicked) {
    start({"picture.ppm"});
    const Screen before = first_screen();
    key("ctrl+p");
    type("see 709");
    key("Return");
    const Screen luma = screen_where(
        [&](const Screen& now) { return now.changed(before, picture()) > 0.9; }, "the luma");
    EXPECT_EQ(places().count("palette.search"), 0U) << "it is still open";
    key("ctrl+z");
    screen_where(is(before), "the picture");
    key("ctrl+p");
    type("see 709");
    click("palette.0");
    screen_where(is(luma), "the luma by a click");
    key("shift+v");
    screen_where(is(before), "the picture by its key");
    key("ctrl+p");
    key("Escape");
    EXPECT_EQ(places().count("palette.search"), 0U);
    key("ctrl+p");
    type("panel cube");
    key("Return");
    place("cube.front");
}

TEST_F(WindowPalette, chooses_how_finely_light_is_worked_out) {
    start({"studio"}); // whose shadow maps are coarse in this test
    const Screen before = first_screen();
    for (const char* words : {"shadow filter 5x5", "occlusion resolution quarter"}) {
        key("ctrl+p");
        type(words);
        key("Return");
        screen_where([&](const Screen& now) { return now.changed(before, picture()) > 0.005; },
                     words);
        key("ctrl+z");
        screen_where(is(before), "the usual light");
    }
}

TEST_F(WindowPalette, reaches_operators_intermediates_scenes_and_exports) {
    start({"plain"});
    const Screen plain = first_screen();
    const auto enter = [&](const std::string& words) {
        key("ctrl+p");
        type(words);
        key("Return");
    };
    enter("intermediate: normal");
    const Screen normals = screen_where(
        [&](const Screen& now) { return now.changed(plain, picture()) > 0.5; }, "the normals");
    enter("show no intermediate");
    screen_where(is(plain), "the picture");
    enter("add the operator (vibrance)");
    place("op0");
    key("ctrl+z");
    enter("export strip unity");
    place("file.name");
    click("file.cancel");
    enter("scene: chart");
    screen_where(
        [&](const Screen& now) {
            return now.changed(plain, picture()) > 0.3 && now.changed(normals, picture()) > 0.3;
        },
        "the chart");
}

} // namespace
} // namespace desktop
