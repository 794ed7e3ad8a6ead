// The exposure by what the picture shows.
#include "tests/preview/window/window_fixture.h"

#include <cmath>

namespace desktop {
namespace {

class WindowMeter : public Window {
  protected:
    static double luma(const Screen& screen, Point at) {
        const std::uint32_t pixel =
            screen.pixels[static_cast<std::size_t>(at.y * screen.width + at.x)];
        const auto light = [&](unsigned shift) {
            const double code = (pixel >> shift & 0xff) / 255.0;
            return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * light(16) + 0.7152 * light(8) + 0.0722 * light(0);
    }
};

TEST_F(WindowMeter, makes_what_is_clicked_or_the_picture_18_percent_grey_and_is_undone) {
    start({"chart", "--tonemap", "none", "--bloom", "none", "--without", "fxaa", "--exposure",
           "-2.5"});
    key("F2"); // without the line of a comparison
    const Screen dark = first_screen();
    click("tab.View");
    scroll_to("meter.pick");
    click("meter.pick");
    const Point at = place("picture").at(0.5, 0.55);
    click(at);
    const auto is_grey = [&](const Screen& now) { return std::abs(luma(now, at) - 0.18) < 0.003; };
    ASSERT_FALSE(is_grey(dark));
    screen_where(is_grey, "18 % there");
    key("ctrl+z");
    screen_where(is(dark), "the exposure that was");
    click("meter");
    screen_where([&](const Screen& now) { return now.changed(dark, picture()) > 0.9; },
                 "another exposure");
    key("ctrl+z");
    screen_where(is(dark), "the exposure that was");
}

TEST_F(WindowMeter, changes_nothing_where_it_has_metered_already) {
    start({"studio", "--exposure", "-2.5", "--without", "fxaa"}); // its bloom and tone map
    key("F2");
    const Screen dark = first_screen();
    click("tab.View");
    scroll_to("meter.pick");
    const Point at = place("picture").at(0.4, 0.6);
    const auto meter = [&] {
        click("meter.pick");
        click(at);
        rest();
    };
    meter();
    const Screen metered = screen_where(
        [&](const Screen& now) { return now.changed(dark, picture()) > 0.5; }, "another exposure");
    for (int i = 0; i < 3; ++i) {
        meter();
        EXPECT_EQ(desktop_->grab().changed(metered, picture()), 0) << i;
    }
    key("ctrl+z"); // one step: the others were none
    screen_where(is(dark), "the exposure that was");
}

} // namespace
} // namespace desktop
