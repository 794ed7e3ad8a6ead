// The line under the picture, and errors over it, in windows of several sizes.
#include "tests/preview/window/window_fixture.h"

namespace desktop {
namespace {

class WindowStatus : public Window {
  protected:
    bool has(const std::string& name) const { return places().count(name) > 0; }
    /// All that the line has ends within it.
    void expect_whole_line() const {
        const Area line = place("status");
        int parts = 0;
        for (const auto& [name, area] : places()) {
            if (name.starts_with("status.")) {
                ++parts;
                EXPECT_GE(area.x, line.x) << name;
                EXPECT_LE(area.x + area.width, line.x + line.width) << name;
            }
        }
        EXPECT_GT(parts, 0);
    }
    void expect_picture_beside_errors() const {
        const Area errors = place("error"), all = place("picture");
        EXPECT_LE(errors.height, all.height * 6 / 10);
        EXPECT_LE(errors.width, all.width * 9 / 10);
        EXPECT_GE(errors.x, all.x);
        EXPECT_LE(errors.x + errors.width, all.x + all.width);
    }
};

TEST_F(WindowStatus, line_is_cut_at_no_width_and_keeps_the_edited_side) {
    start({"plain", "--b", "look.cube"});
    for (const int width : {900, 800, 640}) {
        move_to({0, 0, width, 540});
        act({"mousemove", "60", "100"});
        wait_until([&] { return has("status.B"); }, "the colour under the mouse");
        expect_whole_line();
        EXPECT_FALSE(has("status.invitation"));
    }
    EXPECT_TRUE(has("status.before"));
    // On the panels: nothing is pointed at.
    desktop_->xdotool({"mousemove", "620", "400"});
    wait_until([&] { return has("status.invitation"); }, "the invitation");
    expect_whole_line();
}

TEST_F(WindowStatus, line_tells_the_rest_in_its_tip) {
    start({"plain", "--b", "look.cube"});
    act({"mousemove", "60", "100"});
    wait_until([&] { return has("status.B"); }, "the colour under the mouse");
    desktop_->xdotool({"mousemove", "600", "300"}); // off the picture, on no control's tip
    const Screen before = first_screen();
    const Area line = place("status");
    desktop_->xdotool(mouse_to(line.at(0.2, 0.5)));
    screen_where(
        [&](const Screen& now) {
            return now.changed(before, {line.x, line.y - 90, line.width, 80}) > 0.2;
        },
        "the tip");
}

TEST_F(WindowStatus, errors_leave_most_of_the_picture_and_go_at_once) {
    start({"plain", "--b", "look.cube"});
    const Screen before = first_screen();
    for (const char* const number : {"1", "2", "3", "4", "5", "6", "6", "6"}) {
        key(number); // there is no such version
    }
    EXPECT_TRUE(has("error.3"));
    EXPECT_FALSE(has("error.4"));
    EXPECT_TRUE(has("error.more"));
    expect_picture_beside_errors();
    click("error.0.close");
    EXPECT_TRUE(has("error.3")) << "an older one follows";
    EXPECT_TRUE(has("error.more"));
    click("error.0.close");
    EXPECT_FALSE(has("error.more"));
    key("Escape");
    EXPECT_FALSE(has("error"));
    screen_where(is(before), "the picture alone");
    key("7");
    key("8");
    click("error.close");
    EXPECT_FALSE(has("error")) << "one button closes all";
}

TEST_F(WindowStatus, errors_of_long_names_leave_the_picture_too) {
    start({"plain"});
    const std::string name(90, 'n'); // of several lines
    for (const char* const number : {"1", "2", "3"}) {
        open(name + number + ".cube");
    }
    wait_until([&] { return has("error.close"); }, "the errors");
    expect_picture_beside_errors();
    click("error.close");
    EXPECT_FALSE(has("error"));
}

} // namespace
} // namespace desktop
