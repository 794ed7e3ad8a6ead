// The curves over hue in one plot, by mouse.
#include "tests/preview/window/look_window.h"

namespace desktop {
namespace {

class WindowHues : public LookWindow {
  protected:
    /// Pixels of the plot that are nearly of that colour, such as a curve's.
    int count(const Screen& screen, const Area& plot, int r, int g, int b) const {
        constexpr int near = 40;
        int out = 0;
        for (int y = plot.y; y < plot.y + plot.height; ++y) {
            for (int x = plot.x; x < plot.x + plot.width; ++x) {
                const std::uint32_t pixel =
                    screen.pixels[static_cast<std::size_t>(y * screen.width + x)];
                out += std::abs(static_cast<int>(pixel >> 16 & 0xff) - r) < near &&
                       std::abs(static_cast<int>(pixel >> 8 & 0xff) - g) < near &&
                       std::abs(static_cast<int>(pixel & 0xff) - b) < near;
            }
        }
        return out;
    }
    Screen standing() {
        return screen_where([](const Screen&) { return true; }, "a picture that stands");
    }
};

TEST_F(WindowHues, share_a_plot_in_which_one_is_edited_and_others_are_seen_where_ticked) {
    start_with(R"({"op": "hue-vs-sat", "curve": [[0, 1], [120, 0.2], [240, 1]]})", "880x530");
    click("page.Hues");
    first_screen();
    const std::string plot = "page.Hues";
    const Area area = place(plot + ".hue-vs-hue"); // edited first, as it is the first
    click(area.at(0.5, 0.25));
    const nlohmann::json turned = saved()["operators"];
    ASSERT_EQ(turned.size(), 2U);
    EXPECT_EQ(turned[0]["op"], "hue-vs-sat");
    EXPECT_EQ(turned[0]["curve"].size(), 3U) << "the other curve was changed";
    EXPECT_EQ(turned[1]["op"], "hue-vs-hue");
    double knot = 0;
    for (const auto& at : turned[1]["curve"]) {
        knot = at[1] != 0 ? at[0].get<double>() : knot;
    }
    EXPECT_NEAR(knot, 180, 12);
    // The dimmed curve in its own colour is there while it is ticked.
    const int seen = count(standing(), area, 190, 170, 90);
    click(plot + ".hue-vs-sat.seen");
    const int hidden = count(standing(), area, 190, 170, 90);
    EXPECT_GT(seen, hidden + area.width / 4) << "the saturation curve was not drawn";
    click(plot + ".hue-vs-sat.seen");
    EXPECT_EQ(count(standing(), area, 190, 170, 90), seen);
    // Edited, it takes the mouse; the other stays.
    click(plot + ".hue-vs-sat.edit");
    const Area sat = place(plot + ".hue-vs-sat");
    EXPECT_EQ(sat.y, area.y);
    click(sat.at(0.9, 0.3));
    const nlohmann::json more = saved()["operators"];
    EXPECT_EQ(more[0]["curve"].size(), 4U);
    EXPECT_EQ(more[1], turned[1]);
    key("ctrl+z");
    EXPECT_EQ(saved()["operators"], turned);
    // By choice each has its own plot.
    click("page.one-plot");
    place("page.hue-vs-hue.curve");
    EXPECT_EQ(places().count(plot + ".hue-vs-sat"), 0U);
    click("page.one-plot");
    place(plot + ".hue-vs-sat");
}

} // namespace
} // namespace desktop
