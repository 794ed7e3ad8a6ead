// The panel Look by mouse and keys: wheels, pages, operators off, alone, faded and in another
// order.
#include "tests/preview/window/look_window.h"

namespace desktop {
namespace {

class WindowLook : public LookWindow {
  protected:
    void double_click(Point at) {
        act(mouse_to(at) + Words{"click", "--repeat", "2", "--delay", "60", "1"});
    }
    /// Types a number into a field, as its tooltip says.
    void put(const std::string& name, const std::string& number) {
        act(mouse_to(place(name).at(0.5, 0.5)) +
            Words{"keydown", "ctrl", "click", "1", "sleep", "0.5", "keyup", "ctrl"});
        key("ctrl+a");
        type(number);
        key("Return");
    }
    Screen changed_from(const Screen& before, const std::string& what) {
        return screen_where(
            [&](const Screen& now) { return now.changed(before, between(0.5, 1)) > 0.3; }, what);
    }
};

TEST_F(WindowLook, has_wheels_that_are_dragged_typed_and_reset) {
    start_with("");
    click("page.Wheels");
    const Screen neutral = first_screen();
    const Area gain = place("page.lift-gamma-gain.gain");
    drag(gain.at(0.5, 0.5), gain.at(0.5, 0.4), gain.at(0.5, 0.25));
    const Screen red = changed_from(neutral, "more red");
    nlohmann::json op = saved()["operators"].at(0);
    EXPECT_EQ(op["op"], "lift-gamma-gain");
    EXPECT_GT(op["gain"][0], 1.1);
    EXPECT_LT(op["gain"][1], 1);
    EXPECT_FALSE(op.contains("lift"));
    // The ring, clockwise from its top.
    drag(gain.at(0.5, 0.06), gain.at(0.65, 0.09), gain.at(0.81, 0.19));
    const double dark = op["gain"][1];
    op = saved()["operators"].at(0);
    EXPECT_GT(op["gain"][1], dark + 0.2);
    double_click(gain.at(0.5, 0.06));
    EXPECT_NEAR(saved()["operators"].at(0)["gain"][1], dark, 2e-4) << "of rounded values";
    double_click(gain.at(0.5, 0.5));
    EXPECT_FALSE(saved()["operators"].at(0).contains("gain"));
    screen_where(is(neutral), "the neutral look");
    key("ctrl+z");
    screen_where(is(red), "the wheel where it was");

    put("page.lift-gamma-gain.lift.b", "0.125");
    op = saved()["operators"].at(0);
    EXPECT_EQ(op["lift"], (std::vector<double>{0, 0, 0.125}));
    put("page.lift-gamma-gain.gamma.y", "1.2");
    EXPECT_NEAR(saved()["operators"].at(0)["gamma"][0], 1.2, 1e-9);
    // What is saved is what lutconv makes.
    click("tab.Files");
    export_by("export-strip");
    ASSERT_EQ(say({LUTCONV, "bake", "look.json", "-o", "baked.png"}, desktop_->folder()).code, 0);
    EXPECT_EQ(contents("look-piccolo.png"), contents("baked.png"));
}

TEST_F(WindowLook, has_a_page_of_the_cdl_whose_operator_comes_with_the_first_change) {
    start_with("");
    click("page.CDL");
    const Screen neutral = first_screen();
    EXPECT_TRUE(saved()["operators"].empty());
    put("page.cdl.slope.g", "0.5");
    const Screen less = changed_from(neutral, "less green");
    EXPECT_EQ(saved()["operators"].at(0)["slope"], (std::vector<double>{1, 0.5, 1}));
    key("ctrl+z");
    screen_where(is(neutral), "no operator");
    EXPECT_TRUE(saved()["operators"].empty());
}

TEST_F(WindowLook, leaves_operators_out_and_shows_one_alone_by_key) {
    start_with(R"({"op": "exposure", "stops": 1}, {"op": "saturation", "amount": 0})");
    const Screen both = first_screen();
    EXPECT_EQ(places().count("op0.stops"), 0U) << "operators are open at the start";
    click("op1");
    place("op1.amount");
    key("d");
    const Screen bright = changed_from(both, "colours again");
    EXPECT_EQ(saved()["operators"].at(1)["enabled"], false);
    key("s");
    const Screen grey = changed_from(bright, "saturation alone");
    EXPECT_EQ(saved()["operators"].at(1)["enabled"], false) << "solo was saved";
    EXPECT_GT(grey.changed(both, between(0.5, 1)), 0.3) << "exposure is seen";
    key("s");
    screen_where([&](const Screen& now) { return now.changed(bright, between(0.5, 1)) == 0; },
                 "both again");
    key("ctrl+z");
    screen_where([&](const Screen& now) { return now.changed(grey, between(0.5, 1)) == 0; },
                 "saturation alone again");
    click("op1.solo");
    click("op1.on");
    screen_where([&](const Screen& now) { return now.changed(both, between(0.5, 1)) == 0; },
                 "the whole look");
}

TEST_F(WindowLook, fades_an_operator_and_the_whole_look) {
    start_with(R"({"op": "offset", "amount": [0.4, 0, 0]})");
    const Screen whole = first_screen();
    click("op0");
    put("op0.opacity", "50");
    const Screen half = changed_from(whole, "half of the operator");
    nlohmann::json recipe = saved();
    EXPECT_EQ(recipe["operators"].at(0)["opacity"], 0.5);
    put("look.opacity", "0");
    changed_from(half, "nothing of the look");
    recipe = saved();
    EXPECT_EQ(recipe["opacity"], 0);
    const Said said = say({LUTCONV, "eval", "look.json", "0.2", "0.4", "0.6"}, desktop_->folder());
    EXPECT_NE(said.text.find("0.2"), std::string::npos) << said.text;
    EXPECT_EQ(said.text.find("0.4 "), said.text.rfind("0.4 ")) << said.text;
}

TEST_F(WindowLook, puts_a_dragged_operator_in_the_place_of_another_and_undoes_that) {
    start_with(R"({"op": "exposure", "stops": 1}, {"op": "contrast", "amount": 1.5},
                  {"op": "saturation", "amount": 0.5})");
    first_screen();
    const auto order = [&] {
        std::string out;
        const nlohmann::json recipe = saved();
        for (const auto& op : recipe["operators"]) {
            out += op["op"].get<std::string>() + " ";
        }
        return out;
    };
    const Area first = place("op0"), last = place("op2");
    drag(last.at(0.3, 0.5), first.at(0.3, 1.2), first.at(0.3, 0.5));
    EXPECT_EQ(order(), "saturation exposure contrast ");
    drag(first.at(0.3, 0.5), last.at(0.3, -0.2), last.at(0.3, 0.5));
    EXPECT_EQ(order(), "exposure contrast saturation ");
    key("ctrl+z");
    EXPECT_EQ(order(), "saturation exposure contrast ");
}

TEST_F(WindowLook, finds_operators_and_encodings_by_typing) {
    start_with("");
    first_screen();
    click("add");
    type("vibr");
    EXPECT_EQ(places().count("add.exposure"), 0U);
    click("add.vibrance");
    EXPECT_EQ(saved()["operators"].at(0)["op"], "vibrance");
    place("op0.amount"); // the new one is open
    click("look.encodings");
    click("look.input.curve");
    type("logc3");
    EXPECT_EQ(places().count("look.input.curve.srgb"), 0U);
    click("look.input.curve.logc3");
    EXPECT_EQ(saved()["input"], "logc3");
}

TEST_F(WindowLook, shows_what_qualifiers_choose_as_a_matte) {
    start_with(R"({"op": "hue-range", "centre": 0, "saturation": 0},
                  {"op": "exposure", "stops": 3})");
    const Screen look = first_screen();
    click("op0");
    const Area list = place("panels");
    for (int i = 0; i < 20 && place("op0.matte").y > list.height - 30; ++i) {
        act(mouse_to(list.at(0.6, 0.9)) + Words{"click", "5"});
    }
    click("op0.matte");
    const Screen matte = changed_from(look, "the matte");
    const Area side = between(0.5, 1);
    for (const double across : {0.2, 0.5, 0.8}) {
        for (const double down : {0.1, 0.5, 0.9}) {
            const Point at = side.at(across, down);
            const std::uint32_t pixel =
                matte.pixels[static_cast<std::size_t>(at.y * matte.width + at.x)];
            const int r = static_cast<int>(pixel >> 16 & 0xff),
                      g = static_cast<int>(pixel >> 8 & 0xff);
            EXPECT_NEAR(r, g, 1);
        }
    }
    EXPECT_EQ(saved()["operators"].at(0)["matte"], true);
    const Said said = say({LUTCONV, "bake", "look.json", "-o", "m.png"}, desktop_->folder());
    EXPECT_NE(said.text.find("shows the matte of hue-range"), std::string::npos) << said.text;
    key("ctrl+z");
    screen_where([&](const Screen& now) { return now.changed(look, side) == 0; }, "the look");
}

} // namespace
} // namespace desktop
