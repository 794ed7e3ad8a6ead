// What no person does but a cat: random mouse and keys, under the validation layers, which may have
// nothing to say. Reproducible: the seed gives the same storm on the same window.
#include "tests/preview/window/window_fixture.h"
#include "tests/support/thorough.h"

#include <algorithm>
#include <random>

namespace desktop {
namespace {

namespace fs = std::filesystem;

/// Numbers of a seed that are the same on every machine.
class Dice {
  public:
    explicit Dice(unsigned seed) : numbers_(seed) {}
    /// 0 to below `count`.
    int below(int count) {
        return static_cast<int>(numbers_() % static_cast<std::mt19937::result_type>(count));
    }
    bool once_in(int times) { return below(times) == 0; }
    template <class T>
    const T& one_of(const std::vector<T>& all) {
        return all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
    }

  private:
    std::mt19937 numbers_;
};

// No slash, for what is typed may name a file that is then written; no Ctrl+Q, which ends the
// storm.
const Words keys{"F1",        "F2",         "F3",     "F4",
                 "F5",        "F6",         "F7",     "F8",
                 "Escape",    "Return",     "Tab",    "space",
                 "Delete",    "BackSpace",  "Up",     "Down",
                 "Left",      "Right",      "Home",   "End",
                 "a",         "b",          "c",      "e",
                 "x",         "0",          "1",      "2",
                 "3",         "4",          "5",      "6",
                 "7",         "8",          "9",      "period",
                 "minus",     "ctrl+z",     "ctrl+y", "ctrl+z",
                 "ctrl+s",    "ctrl+e",     "ctrl+a", "ctrl+p",
                 "ctrl+1",    "ctrl+2",     "ctrl+9", "ctrl+v",
                 "ctrl+plus", "ctrl+minus", "ctrl+0", "ctrl+shift+z",
                 "shift+1",   "alt+a"};
const Words modifiers{"ctrl", "shift", "alt"};

class WindowStorm : public Window {
  protected:
    static constexpr int gestures_in_batch = 12;

    Point anywhere(Dice& dice, const std::vector<Area>& controls) const {
        if (controls.empty() || dice.once_in(4)) {
            return {dice.below(screen_width), dice.below(screen_height)};
        }
        const Area& control = dice.one_of(controls);
        return {std::max(control.x + dice.below(std::max(control.width, 1)), 0),
                std::max(control.y + dice.below(std::max(control.height, 1)), 0)};
    }

    Words gesture(Dice& dice, const std::vector<Area>& controls) const {
        const Point at = anywhere(dice, controls);
        const std::string button = dice.one_of(Words{"1", "1", "1", "1", "2", "3"});
        switch (dice.below(8)) {
        case 0:
        case 1:
        case 2: { // a click, or several
            Words out = mouse_to(at);
            for (int i = dice.once_in(4) ? 3 : 1; i > 0; --i) {
                out = out + Words{"mousedown", button, "mouseup", button};
            }
            return out;
        }
        case 3: { // a drag, with a key held or not
            Words out = mouse_to(at);
            const std::string held = dice.once_in(3) ? dice.one_of(modifiers) : "";
            if (!held.empty()) {
                out = out + Words{"keydown", held};
            }
            out = out + Words{"mousedown", button};
            for (int i = 0; i < 3; ++i) {
                out = out + mouse_to(anywhere(dice, controls));
            }
            out = out + Words{"mouseup", button};
            return held.empty() ? out : out + Words{"keyup", held};
        }
        case 4: { // the wheel
            Words out = mouse_to(at);
            for (int i = dice.below(5); i >= 0; --i) {
                out = out + Words{"click", dice.once_in(2) ? "4" : "5"};
            }
            return out;
        }
        default:
            return {"key", dice.one_of(keys)};
        }
    }

    /// Rarely: a window of another size, one that is away for a while, a device made anew.
    void disturb(Dice& dice) {
        const Words window{"search", "--name", "lutpreview"};
        switch (dice.below(3)) {
        case 0:
            desktop_->xdotool(window + Words{"windowsize", std::to_string(1 + dice.below(1200)),
                                             std::to_string(1 + dice.below(700))});
            break;
        case 1:
            desktop_->xdotool(window + Words{"windowunmap"});
            desktop_->xdotool(mouse_to({dice.below(screen_width), dice.below(screen_height)}));
            desktop_->xdotool(window + Words{"windowmap"});
            break;
        default:
            desktop_->xdotool({"key", "ctrl+shift+r"});
            break;
        }
    }

    std::vector<Area> controls() const {
        std::vector<Area> out;
        for (const auto& [name, area] : places()) {
            if (name != "frame" && name != "mouse" && area.x < screen_width &&
                area.y < screen_height && area.x + area.width > 0 && area.y + area.height > 0) {
                out.push_back(area);
            }
        }
        return out;
    }

    /// Whatever it was asked, the window ends at a key and has said nothing.
    void rage(unsigned seed, int batches, const Words& shown) {
        start(shown);
        Dice dice(seed);
        for (int batch = 0; batch < batches; ++batch) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", batch " + std::to_string(batch));
            const std::vector<Area> there = controls();
            Words all;
            for (int i = 0; i < gestures_in_batch; ++i) {
                all = all + gesture(dice, there);
            }
            desktop_->xdotool(all);
            if (dice.once_in(12)) {
                disturb(dice);
            }
            // In the window's first pixels, however small it is now.
            const int before = frame();
            desktop_->xdotool(mouse_to({0, 0}) + mouse_to({batch % 2, 1}));
            wait_until([&] { return frame() > before; },
                       "the frames of batch " + std::to_string(batch));
        }
        desktop_->xdotool({"search", "--name", "lutpreview", "windowsize", "800", "480"});
        wait_until([&] { return is_as_large(800, 480); }, "a window of the usual size");
        quit();
        EXPECT_EQ(log(), "") << "seed " << seed;
    }
};

TEST_F(WindowStorm, of_mouse_and_keys_makes_no_message_and_no_crash) {
    rage(1, 60, {"picture.ppm", "--b", "look.cube"}); // a minute
}

TEST_F(WindowStorm, over_a_scene_makes_none_either) {
    const int batches = support::is_thorough() ? 40 : 6;
    for (const unsigned seed : support::all_or<unsigned>({2, 3, 4}, {2})) {
        rage(seed, batches, {"plain", "--b", "look.cube"});
    }
}

} // namespace
} // namespace desktop
