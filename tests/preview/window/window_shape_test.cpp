// The window's place and size on the screen, and how large text and panels are in it.
#include "tests/preview/window/window_fixture.h"

#include <algorithm>

namespace desktop {
namespace {

namespace fs = std::filesystem;

class WindowShape : public Window {
  protected:
    /// Where the window is on the screen, by the X server.
    Area on_screen() const {
        const Said said =
            say({"xdotool", "search", "--name", "lutpreview", "getwindowgeometry", "--shell"},
                desktop_->folder());
        Area out;
        std::istringstream lines(said.text);
        for (std::string line; std::getline(lines, line);) {
            const auto read = [&](const std::string& name, int& number) {
                if (line.starts_with(name + "=")) {
                    number = std::stoi(line.substr(name.size() + 1));
                }
            };
            read("X", out.x);
            read("Y", out.y);
            read("WIDTH", out.width);
            read("HEIGHT", out.height);
        }
        return out;
    }
    std::vector<Area> tabs() const {
        std::vector<Area> out;
        for (const auto& [name, area] : places()) {
            if (name.starts_with("tab.")) {
                out.push_back(area);
            }
        }
        return out;
    }
    static std::vector<int> widths(const std::vector<Area>& areas) {
        std::vector<int> out;
        std::transform(areas.begin(), areas.end(), std::back_inserter(out),
                       [](const Area& area) { return area.width; });
        return out;
    }
    void expect_whole_tabs() const {
        const Area panels = place("panels");
        const std::vector<Area> all = tabs();
        ASSERT_GE(all.size(), 7U);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Area& tab = all[i];
            EXPECT_GE(tab.x, panels.x);
            EXPECT_LE(tab.x + tab.width, panels.x + panels.width);
            for (std::size_t j = 0; j < i; ++j) {
                const Area& other = all[j];
                EXPECT_TRUE(tab.x + tab.width <= other.x || other.x + other.width <= tab.x ||
                            tab.y + tab.height <= other.y || other.y + other.height <= tab.y)
                    << i << " lies over " << j;
            }
        }
    }
};

TEST_F(WindowShape, fits_a_screen_that_is_smaller_than_it_would_be) {
    start_unsized({"picture.ppm"});
    EXPECT_TRUE(is_as_large(screen_width, screen_height));
    EXPECT_EQ(on_screen().x, 0);
    EXPECT_EQ(on_screen().y, 0);
}

TEST_F(WindowShape, is_where_it_was_and_as_large) {
    start_unsized({"picture.ppm"});
    move_to({120, 30, 700, 450});
    quit();
    launch({"picture.ppm"});
    EXPECT_TRUE(is_as_large(700, 450));
    EXPECT_EQ(on_screen().x, 120);
    EXPECT_EQ(on_screen().y, 30);
    quit();
    start({"picture.ppm"}); // a size that is asked for holds, and is not remembered
    EXPECT_TRUE(is_as_large(800, 480));
    quit();
    launch({"picture.ppm"});
    EXPECT_TRUE(is_as_large(700, 450));
}

TEST_F(WindowShape, comes_onto_the_screen_from_where_none_is_any_more) {
    std::filesystem::create_directories(file("lutpreview"));
    std::ofstream(file("lutpreview/window.json"))
        << R"({"area": {"x": 4000, "y": -3000, "width": 600, "height": 5000}})";
    launch({"picture.ppm"});
    EXPECT_TRUE(is_as_large(600, screen_height));
    EXPECT_EQ(on_screen().x, screen_width - 600);
    EXPECT_EQ(on_screen().y, 0);
}

TEST_F(WindowShape, opens_as_for_the_first_time_over_a_broken_file_and_says_so) {
    std::filesystem::create_directories(file("lutpreview"));
    std::ofstream(file("lutpreview/window.json")) << "{\"area\": 3";
    start_unsized({"picture.ppm"});
    EXPECT_TRUE(is_as_large(screen_width, screen_height));
    EXPECT_EQ(places().count("error.close"), 1U);
    click("error.close");
    quit();
    EXPECT_NE(contents("lutpreview/window.json").find("\"area\": {"), std::string::npos);
}

TEST_F(WindowShape, shows_every_tab_whole_however_narrow_it_is) {
    start({"picture.ppm"});
    expect_whole_tabs();
    const std::vector<int> whole = widths(tabs());
    for (const int width : {640, 420, 300}) {
        move_to({0, 0, width, 480});
        expect_whole_tabs();
        EXPECT_EQ(widths(tabs()), whole) << width;
    }
}

TEST_F(WindowShape, has_larger_text_by_a_key_until_it_is_told_otherwise) {
    start({"picture.ppm"});
    const Area undo = place("undo"), panels = place("panels");
    const auto larger = [&] { return place("undo").height > 1.3 * undo.height; };
    act({"key", "ctrl+plus", "key", "ctrl+plus", "key", "ctrl+plus", "key", "ctrl+plus"});
    EXPECT_TRUE(larger());
    EXPECT_GT(place("undo").width, 1.3 * undo.width);
    expect_whole_tabs();
    quit();
    start({"picture.ppm"});
    EXPECT_TRUE(larger());
    key("ctrl+0");
    EXPECT_EQ(place("undo").height, undo.height);
    EXPECT_EQ(place("panels").width, panels.width);
    act({"key", "ctrl+minus"});
    EXPECT_LT(place("undo").height, undo.height);
}

TEST_F(WindowShape, has_larger_text_where_the_desktop_has) {
    start({"picture.ppm"});
    const Area undo = place("undo");
    quit();
    // GLFW asks for it as desktops tell it, in resources of the screen.
    if (say({"xprop", "-root", "-f", "RESOURCE_MANAGER", "8s", "-set", "RESOURCE_MANAGER",
             "Xft.dpi:\t192\n"},
            desktop_->folder())
            .code != 0) {
        GTEST_SKIP() << "xprop is missing (scripts/setup --tests installs it)";
    }
    start({"picture.ppm"});
    EXPECT_NEAR(place("undo").height, 2 * undo.height, 1);
    EXPECT_NEAR(place("undo").width, 2 * undo.width, 4);
}

} // namespace
} // namespace desktop
