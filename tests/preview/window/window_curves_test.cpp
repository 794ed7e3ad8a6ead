// Curves of the panel Look and colours that are picked in the picture, by mouse and keys.
#include "tests/preview/window/look_window.h"

namespace desktop {
namespace {

class WindowCurves : public LookWindow {};

TEST_F(WindowCurves, are_square_with_knots_that_are_typed_and_channels_of_their_own) {
    start_with("", "880x530");
    click("page.Curves");
    const Screen neutral = first_screen();
    const Area plot = place("page.curves.master");
    EXPECT_EQ(plot.width, plot.height);
    scroll_to("page.curves.master.typed");
    click("page.curves.master.typed");
    type("0:0, 0.5:0.75, 1:1");
    key("Return");
    const Screen bright =
        screen_where([&](const Screen& now) { return now.changed(neutral, between(0.5, 1)) > 0.5; },
                     "the curve");
    const nlohmann::json knots = {{0, 0}, {0.5, 0.75}, {1, 1}};
    EXPECT_EQ(saved()["operators"].at(0)["master"], knots);
    click("page.curves.master.typed");
    key("ctrl+a");
    type("0:0, 0.5:x");
    key("Return");
    EXPECT_EQ(saved()["operators"].at(0)["master"], knots) << "what is no knot changed the curve";
    scroll_to("page.curves.red.edit");
    click("page.curves.red.edit");
    const Area red = place("page.curves.red");
    const Area all = place("panels");
    ASSERT_LT(red.y + red.height / 3, all.height);
    click(red.at(0.75, 0.25));
    const nlohmann::json op = saved()["operators"].at(0);
    EXPECT_EQ(op["master"], knots);
    ASSERT_EQ(op["red"].size(), 3U);
    EXPECT_NEAR(op["red"][1][0], 0.75, 0.03);
    EXPECT_NEAR(op["red"][1][1], 0.75, 0.03);
    // The knot that was clicked shows its numbers.
    scroll_to("page.curves.red.knot.y");
    act(mouse_to(place("page.curves.red.knot.y").at(0.5, 0.5)) +
        Words{"keydown", "ctrl", "click", "1", "sleep", "0.5", "keyup", "ctrl"});
    key("ctrl+a");
    type("0.25");
    key("Return");
    EXPECT_EQ(saved()["operators"].at(0)["red"][1][1], 0.25);
    key("ctrl+z");
    EXPECT_EQ(saved()["operators"].at(0)["red"], op["red"]);
}

TEST_F(WindowCurves, get_a_knot_at_the_hue_that_is_picked_in_the_picture) {
    start_with(R"({"op": "hue-vs-sat"})", "880x530");
    first_screen();
    click("op0");
    scroll_to("op0.curve.pick");
    click("op0.curve.pick");
    const Area all = place("picture");
    click(all.at(0.95, 0.05)); // 242, 13, 128
    const nlohmann::json knots = saved()["operators"].at(0)["curve"];
    ASSERT_EQ(knots.size(), 3U);
    const Said said =
        say({LUTCONV, "eval", "look.json", "0.95", "0.05", "0.5"}, desktop_->folder());
    EXPECT_EQ(said.code, 0);
    // Between magenta and red, of full saturation.
    double hue = 0;
    for (const auto& knot : knots) {
        hue = knot[1] == 1 && knot[0] > 300 ? knot[0].get<double>() : hue;
    }
    EXPECT_GT(hue, 320);
    key("ctrl+z");
    EXPECT_FALSE(saved()["operators"].at(0).contains("curve"));
}

TEST_F(WindowCurves, white_balance_makes_what_is_picked_neutral) {
    start_with(R"({"op": "white-balance"})", "880x530");
    first_screen();
    key("F3");
    click("op0");
    click("op0.pick");
    const Point at = place("picture").at(0.55, 0.45); // 140, 115, 128
    click(at);
    const nlohmann::json op = saved()["operators"].at(0);
    EXPECT_TRUE(op.contains("tint"));
    const Screen now = screen_where(
        [&](const Screen& screen) {
            const std::uint32_t pixel =
                screen.pixels[static_cast<std::size_t>(at.y * screen.width + at.x)];
            const int r = static_cast<int>(pixel >> 16 & 0xff),
                      g = static_cast<int>(pixel >> 8 & 0xff), b = static_cast<int>(pixel & 0xff);
            // Codes of 8 bits, antialiased, and a table between its nodes.
            return std::abs(r - g) <= 3 && std::abs(b - g) <= 3;
        },
        "a neutral pixel");
    click("op0.pick");
    key("Escape");
    click(at); // picks nothing
    EXPECT_EQ(saved()["operators"].at(0), op);
}

} // namespace
} // namespace desktop
