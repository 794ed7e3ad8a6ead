// The scopes under the picture: frozen, and of a region that is dragged.
#include "tests/preview/window/window_fixture.h"

#include <algorithm>

namespace desktop {
namespace {

class WindowScopes : public Window {
  protected:
    /// Black on the left, white on the right.
    static Screen halves(int width, int height) {
        Screen out{width, height, {}};
        for (int i = 0; i < width * height; ++i) {
            out.pixels.push_back(i % width < width / 2 ? 0U : 0xffffffU);
        }
        return out;
    }
    /// The waveform, below what is written over it.
    Area waveform() const {
        const Area all = place("scope.seen.waveform");
        return {all.x + 3, all.y + 30, all.width - 6, all.height - 33};
    }
    /// How many pixels of the waveform, all of it, have this colour.
    int count(const Screen& screen, std::uint32_t color) const {
        const Area all = place("scope.seen.waveform");
        int out = 0;
        for (int y = all.y; y < all.y + all.height; ++y) {
            for (int x = all.x; x < all.x + all.width; ++x) {
                const auto at = static_cast<std::size_t>(y * screen.width + x);
                out += (screen.pixels[at] & 0xffffff) == color ? 1 : 0;
            }
        }
        return out;
    }
    /// Marks of clipped texels.
    static constexpr std::uint32_t black_mark = 0x296bff, white_mark = 0xff3829;
    static constexpr std::uint32_t frozen = 0xffb020;
};

TEST_F(WindowScopes, keep_what_they_show_while_they_are_frozen) {
    start({"picture.ppm", "--b", "look.cube", "--compare", "a", "--scope", "waveform"});
    first_screen();
    wait_until([&] { return places().count("scope.seen.waveform") > 0; }, "the waveform");
    const Screen live = screen_where(
        [&](const Screen& now) { return now.changed(black(), waveform()) > 0.9; }, "a waveform");
    EXPECT_EQ(count(live, frozen), 0);
    key("f");
    const Screen kept =
        screen_where([&](const Screen& now) { return count(now, frozen) > 500; }, "a label");
    EXPECT_EQ(kept.changed(live, waveform()), 0);
    key("F3");
    const Screen graded = screen_where(
        [&](const Screen& now) { return now.changed(kept, picture()) > 0.5; }, "side B");
    EXPECT_EQ(graded.changed(kept, waveform()), 0) << "what was counted before";
    key("ctrl+shift+r"); // everything on the GPU is made anew
    rest();
    EXPECT_EQ(desktop_->grab().changed(kept, waveform()), 0);
    key("F6"); // a heat map has nothing to count
    screen_where([&](const Screen& now) { return now.changed(graded, picture()) > 0.5; },
                 "the difference");
    EXPECT_EQ(desktop_->grab().changed(kept, waveform()), 0);
    key("F3");
    screen_where(is(graded), "side B again");
    click("tab.Scopes");
    click("scope.freeze");
    screen_where(
        [&](const Screen& now) {
            return count(now, frozen) == 0 && now.changed(kept, waveform()) > 0.02;
        },
        "the waveform of side B");
    key("F6");
    wait_until([&] { return count(desktop_->grab(), white_mark) == 0; }, "no counts");
    key("f");
    wait_until([&] { return places().count("error.close") > 0; }, "the reason");
    click("error.close");
    rest();
    EXPECT_EQ(count(desktop_->grab(), frozen), 0);
}

TEST_F(WindowScopes, count_a_region_that_is_dragged) {
    halves(400, 480).write(file("halves.ppm"));
    start({"halves.ppm", "--compare", "a", "--scope", "waveform"});
    const auto shows = [&](bool black, bool white) {
        return [this, black, white](const Screen& now) {
            return (count(now, black_mark) > 20) == black && (count(now, white_mark) > 20) == white;
        };
    };
    const Screen whole = screen_where(shows(true, true), "black and white");
    click("tab.Scopes");
    click("scope.region.drag");
    const Area all = place("picture");
    drag(all.at(0.6, 0.2), all.at(0.7, 0.3), all.at(0.9, 0.8));
    const Screen right = screen_where(shows(false, true), "white alone");
    EXPECT_GT(right.changed(whole, picture()), 0.001) << "the region's border";
    EXPECT_LT(right.changed(whole, picture()), 0.05);
    click("scope.region.drag");
    key("Escape");
    drag(all.at(0.1, 0.2), all.at(0.2, 0.3), all.at(0.3, 0.8));
    rest();
    EXPECT_TRUE(shows(false, true)(desktop_->grab())) << "Escape ends it";
    key("ctrl+p");
    type("scopes: drag");
    key("Return");
    drag(all.at(0.1, 0.2), all.at(0.2, 0.3), all.at(0.3, 0.8));
    screen_where(shows(true, false), "black alone");
    key("ctrl+z");
    screen_where(shows(false, true), "the first region");
    click("scope.region.clear");
    screen_where(shows(true, true), "all of it");
}

// Side A is left of the line: turned by a quarter it is above, and has half as much white.
TEST_F(WindowScopes, count_one_side_however_the_border_lies) {
    halves(400, 480).write(file("halves.ppm"));
    start({"halves.ppm", "--compare", "split", "--scope", "waveform", "--scope-side", "a"});
    // Its mark is two rows high.
    const auto has_white_between = [&](double least, double most) {
        return [this, least, most](const Screen& now) {
            const double width = 2 * place("scope.seen.waveform").width;
            const int marks = count(now, white_mark);
            return marks >= least * width && marks <= most * width;
        };
    };
    screen_where(
        [&](const Screen& now) {
            return count(now, black_mark) > 20 && has_white_between(0, 0)(now);
        },
        "the left half");
    key("shift+F4");
    screen_where(has_white_between(0.3, 0.6), "the upper half");
    key("shift+F4");
    screen_where(has_white_between(0.8, 1), "the right half");
}

} // namespace
} // namespace desktop
