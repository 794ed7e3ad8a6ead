// What the levels of the window's scopes stand for, and how bright their counts are.
#include "tests/preview/window/window_fixture.h"

namespace desktop {
namespace {

class WindowLevels : public Window {
  protected:
    /// Texels of the red trace between these shares of the parade's height, from above.
    int red(const Screen& screen, double from, double to) const {
        const Area seen = place("scope.seen.parade");
        const Point first = seen.at(0, from), last = seen.at(1, to);
        int out = 0;
        for (int y = first.y; y < last.y; ++y) {
            for (int x = first.x; x < last.x; ++x) {
                const std::uint32_t pixel =
                    screen.pixels[static_cast<std::size_t>(y * screen.width + x)];
                const auto r = pixel >> 16 & 255, g = pixel >> 8 & 255;
                out += r > 100 && 2 * g < r ? 1 : 0;
            }
        }
        return out;
    }
    /// Of all the parade.
    double green(const Screen& screen) const {
        const Area seen = place("scope.seen.parade");
        double out = 0;
        for (int y = seen.y; y < seen.y + seen.height; ++y) {
            for (int x = seen.x; x < seen.x + seen.width; ++x) {
                out += screen.pixels[static_cast<std::size_t>(y * screen.width + x)] >> 8 & 255;
            }
        }
        return out;
    }
};

// Of a gradient to 255: in codes it ends above, in PQ at the display's white.
TEST_F(WindowLevels, are_of_the_encoding_that_is_chosen_and_white_is_where_colours_name_it) {
    start({"picture.ppm"});
    first_screen();
    click("tab.Scopes");
    click("scope.parade");
    const Screen codes = screen_where(
        [&](const Screen& now) {
            return places().count("scope.seen.parade") > 0 && red(now, 0.1, 0.4) > 20;
        },
        "codes up to the top");
    click("scope.levels.encoded");
    screen_where(
        [&](const Screen& now) { return red(now, 0.02, 0.42) == 0 && red(now, 0.45, 0.7) > 20; },
        "PQ up to 100 cd/m2");
    EXPECT_EQ(places().count("scope.levels.curve"), 1U);
    click("tab.Colours");
    const Area white = place("color.white");
    drag(white.at(0.3, 0.5), white.at(0.5, 0.5), white.at(0.99, 0.5));
    screen_where(
        [&](const Screen& now) { return red(now, 0.02, 0.2) == 0 && red(now, 0.22, 0.4) > 5; },
        "PQ up to 1000 cd/m2");
    key("ctrl+p");
    type("scope levels linear light");
    key("Return");
    screen_where([&](const Screen& now) { return red(now, 0.02, 0.2) > 2; }, "linear light");
    click("tab.Scopes");
    click("scope.levels.shown");
    const Area seen = place("scope.seen.parade");
    screen_where([&](const Screen& now) { return now.changed(codes, seen) == 0; }, "codes again");
}

TEST_F(WindowLevels, are_brighter_by_a_gain_which_undo_takes_back) {
    start({"picture.ppm", "--scope", "parade"});
    first_screen();
    const Screen usual = screen_where(
        [&](const Screen& now) {
            return places().count("scope.seen.parade") > 0 && red(now, 0.1, 0.4) > 20;
        },
        "a parade");
    const Area seen = place("scope.seen.parade");
    key("ctrl+p");
    type("scope gain -12 dB");
    key("Return");
    screen_where([&](const Screen& now) { return green(now) < 0.8 * green(usual); }, "less light");
    key("ctrl+z");
    screen_where([&](const Screen& now) { return now.changed(usual, seen) == 0; }, "as it was");
    click("tab.Scopes");
    EXPECT_EQ(places().count("scope.gain"), 1U);
}

} // namespace
} // namespace desktop
