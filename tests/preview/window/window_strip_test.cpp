// The looks of a folder as a strip of small pictures under the picture.
#include "tests/preview/window/window_fixture.h"

#include <algorithm>
#include <cmath>

namespace desktop {
namespace {

namespace fs = std::filesystem;

/// What is in a binary PPM file.
Screen read_ppm(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    int most = 0;
    Screen out;
    file >> magic >> out.width >> out.height >> most;
    file.get();
    for (int i = 0; file && i < out.width * out.height; ++i) {
        const int r = file.get(), g = file.get(), b = file.get();
        out.pixels.push_back(static_cast<std::uint32_t>(r << 16 | g << 8 | b));
    }
    return out;
}

class WindowStrip : public Window {
  protected:
    void SetUp() override {
        Window::SetUp();
        if (!desktop_) {
            return;
        }
        fs::create_directory(file("looks"));
        const fs::path from(LUT_LOOKS_FOLDER);
        fs::copy_file(from / "bleach_bypass.cube", file("looks/a.cube"));
        std::ofstream(file("looks/b.json"))
            << R"({"schema_version": 1, "input": "srgb", "operators": [)"
               R"({"op": "contrast", "amount": 1.5}, {"op": "saturation", "amount": 0.2}]})";
        std::ofstream(file("looks/notes.txt")) << "x";
    }
    /// The strip open, with the pictures of these looks.
    void open_strip(const Words& names) {
        key("l");
        for (const std::string& name : names) {
            wait_for_picture(name);
        }
    }
    bool has(const std::string& name) const { return places().count(name) > 0; }
    void wait_for_picture(const std::string& name) {
        wait_until([&] { return has("picture-of." + name); }, "the picture of " + name);
    }
    int drawn() const { return place("thumbnails-drawn").x; }
    /// Of those beside the strip's own.
    void choose_folder(const std::string& name) {
        click("strip.folder");
        click("file.up");
        type(name);
        key("Return");
        click("file.choose");
    }
    /// Waits until so many have been drawn since the start and no more are.
    void wait_drawn(int count) {
        wait_until([&] { return drawn() >= count; }, std::to_string(count) + " pictures");
        rest();
        EXPECT_EQ(drawn(), count);
    }
    /// The largest difference of a code between what is on the screen there and the picture.
    int difference(const Area& area, const Screen& picture) const {
        const Screen now = desktop_->grab();
        int most = 0;
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x) {
                const auto is =
                    now.pixels[static_cast<std::size_t>((area.y + y) * now.width + area.x + x)];
                const auto should = picture.pixels[static_cast<std::size_t>(y * picture.width + x)];
                for (const int shift : {0, 8, 16}) {
                    most = std::max(most, std::abs(static_cast<int>(is >> shift & 255) -
                                                   static_cast<int>(should >> shift & 255)));
                }
            }
        }
        return most;
    }
};

TEST_F(WindowStrip, shows_the_picture_under_each_look_as_the_program_renders_it_that_small) {
    start_unsized({"--size", "800x530", "picture.ppm", "--b", "looks/a.cube"});
    first_screen();
    open_strip({"a.cube", "b.json"});
    EXPECT_FALSE(has("strip.notes.txt"));
    rest();
    for (const std::string name : {"a.cube", "b.json"}) {
        const Area area = place("picture-of." + name);
        const std::string size = std::to_string(area.width) + "x" + std::to_string(area.height);
        const Said said = say({LUTPREVIEW, "picture.ppm", "--b", "looks/" + name, "--compare", "b",
                               "--headless", "--size", size, "-o", name + ".ppm"},
                              desktop_->folder());
        ASSERT_EQ(said.code, 0) << said.text;
        const Screen expected = read_ppm(file(name + ".ppm"));
        ASSERT_EQ(expected.width, area.width);
        ASSERT_EQ(expected.height, area.height);
        // The window samples a recipe more coarsely.
        EXPECT_LE(difference(area, expected), name == "b.json" ? 6 : 1) << name;
    }
    // Side B of the picture is that look, side A another.
    EXPECT_GT(difference(place("picture-of.a.cube"), read_ppm(file("b.json.ppm"))), 20);
}

TEST_F(WindowStrip, loads_a_look_by_a_click_and_by_keys_which_undo_takes_back) {
    start_unsized({"--size", "800x530", "picture.ppm", "--b", "looks/a.cube"});
    first_screen();
    open_strip({"a.cube", "b.json"});
    const Screen first = first_screen();
    click("strip.b.json");
    const Screen second = screen_where(
        [&](const Screen& now) { return now.changed(first, between(0.5, 1)) > 0.5; }, "the look");
    EXPECT_EQ(second.changed(first, between(0, 0.5)), 0) << "side A shows it too";
    key("ctrl+z");
    screen_where(is(first), "the first look");
    key("Next");
    screen_where(is(second), "the look after it");
    key("Next"); // around the end
    screen_where(is(first), "the first look");
    key("Prior");
    screen_where(is(second), "the look before it");
    click("strip.close");
    EXPECT_FALSE(has("strip.b.json"));
    key("ctrl+z");
    key("Next"); // also while it is closed
    click("tab.Files");
    EXPECT_EQ(contents("window.txt"), "");
    key("l");
    EXPECT_TRUE(has("strip.b.json"));
    screen_where(is(second), "the look");
}

TEST_F(WindowStrip, says_why_a_look_has_no_picture_and_leaves_out_what_is_none) {
    std::ofstream(file("looks/broken.cube")) << "LUT_3D_SIZE 2\n0 0\n";
    gradient(20, 20).write(file("looks/photo.ppm"));
    fs::copy_file(fs::path(LUT_LOOKS_FOLDER) / "report.png", file("looks/report.png"));
    start_unsized({"--size", "800x530", "picture.ppm", "--b", "looks/a.cube"});
    first_screen();
    key("l");
    wait_until([&] { return has("reason-of.broken.cube"); }, "the reason");
    wait_for_picture("b.json");
    act(mouse_to(place("strip.a.cube").at(0.5, 0.5)) + Words{"click", "5"}); // the wheel
    wait_until([&] { return !has("strip.report.png"); }, "the picture that is no look to go");
    EXPECT_FALSE(has("strip.photo.ppm"));
    // It does not keep others from being reached.
    const Screen first = first_screen();
    key("Prior"); // before the first is the last, past nothing
    key("Prior"); // past what is broken
    screen_where([&](const Screen& now) { return now.changed(first, picture()) == 0; },
                 "the look before the broken one");
    EXPECT_FALSE(has("error.close"));
    // Once it is mended it has its picture.
    fs::copy_file(file("look.cube"), file("looks/broken.cube"),
                  fs::copy_options::overwrite_existing);
    wait_for_picture("broken.cube");
    EXPECT_FALSE(has("reason-of.broken.cube"));
}

TEST_F(WindowStrip, follows_its_folder) {
    start_unsized({"--size", "800x530", "picture.ppm", "--b", "looks/a.cube"});
    first_screen();
    open_strip({"a.cube", "b.json"});
    wait_drawn(2);
    const Screen before = first_screen();
    const Area of_b = place("picture-of.b.json");
    std::ofstream(file("looks/b.json"))
        << R"({"schema_version": 1, "operators": [{"op": "exposure", "stops": -3}]})";
    screen_where([&](const Screen& now) { return now.changed(before, of_b) > 0.5; },
                 "the changed look's picture");
    wait_drawn(3);
    fs::copy_file(file("look.cube"), file("looks/aa.cube"));
    wait_for_picture("aa.cube");
    fs::remove(file("looks/aa.cube"));
    wait_until([&] { return !has("strip.aa.cube"); }, "the deleted look to go");
    fs::create_directory(file("others"));
    fs::copy_file(file("look.cube"), file("others/c.cube"));
    choose_folder("others");
    wait_for_picture("c.cube");
    EXPECT_FALSE(has("strip.a.cube"));
    click("strip.own");
    wait_for_picture("a.cube");
}

TEST_F(WindowStrip, is_open_in_the_next_window_with_its_folder) {
    fs::create_directory(file("others"));
    fs::copy_file(file("look.cube"), file("others/c.cube"));
    start_unsized({"--size", "800x530", "picture.ppm", "--b", "looks/a.cube"});
    first_screen();
    open_strip({"a.cube"});
    quit();
    start_unsized({"--size", "800x530", "picture.ppm", "--b", "looks/a.cube"});
    wait_for_picture("b.json");
    choose_folder("others");
    wait_for_picture("c.cube");
    quit();
    start_unsized({"--size", "800x530", "picture.ppm", "--b", "looks/a.cube"});
    wait_for_picture("c.cube");
    EXPECT_FALSE(has("strip.a.cube"));
    click("strip.own");
    click("strip.close");
    quit();
    fs::remove_all(file("others"));
    start_unsized({"--size", "800x530", "picture.ppm", "--b", "looks/a.cube"});
    first_screen();
    EXPECT_FALSE(has("strip.close"));
    key("l");
    wait_for_picture("a.cube"); // of the look's own folder again
}

TEST_F(WindowStrip, rests_while_files_that_are_no_looks_change_beside_them) {
    start_unsized({"--size", "800x530", "picture.ppm", "--b", "look.cube"});
    first_screen();
    open_strip({"look.cube"}); // beside where the window tells its places
    rest();
    const int last = frame();
    std::ofstream(file("notes.txt")) << "x";
    rest();
    EXPECT_EQ(frame(), last);
}

TEST_F(WindowStrip, draws_what_is_seen_once_nobody_drags_and_rests) {
    for (int i = 0; i < 40; ++i) {
        fs::copy_file(file("look.cube"), file("looks/c" + std::to_string(i) + ".cube"));
    }
    start_unsized({"--size", "800x530", "plain", "--b", "looks/a.cube"});
    first_screen();
    rest();
    EXPECT_EQ(drawn(), 0) << "the strip is closed";
    open_strip({"a.cube", "b.json", "c0.cube"});
    rest();
    const int seen = drawn();
    EXPECT_LE(seen, 5) << "of 42 looks";
    const Screen before = first_screen();
    const Area of_a = place("picture-of.a.cube"), all = picture();
    // The camera turns under the mouse, which is held.
    desktop_->xdotool(mouse_to(all.at(0.3, 0.5)) + Words{"mousedown", "1"} +
                      mouse_to(all.at(0.2, 0.4)) + mouse_to(all.at(0.1, 0.4)));
    const Screen turned =
        screen_where([&](const Screen& now) { return now.changed(before, between(0, 0.5)) > 0.1; },
                     "another view");
    rest();
    EXPECT_EQ(drawn(), seen) << "drawn during a drag";
    EXPECT_EQ(turned.changed(before, of_a), 0);
    act({"mouseup", "1"});
    screen_where([&](const Screen& now) { return now.changed(before, of_a) > 0.1; },
                 "the small pictures of that view");
    wait_drawn(2 * seen);
    key("ctrl+z");
    screen_where([&](const Screen& now) { return now.changed(before, of_a) == 0; },
                 "those of the first view");
}

TEST_F(WindowStrip, has_its_like_in_the_list_of_scenes_drawn_once) {
    start_unsized({"--size", "800x530", "plain", "--b", "looks/a.cube"});
    first_screen();
    click("tab.Scene");
    EXPECT_EQ(drawn(), 0);
    click("scene.list");
    const Words scenes{"sample", "exterior", "night", "materials", "chart", "studio", "plain"};
    for (const std::string& name : scenes) {
        wait_for_picture("scene." + name);
    }
    wait_drawn(static_cast<int>(scenes.size()));
    const Screen list = desktop_->grab();
    for (std::size_t i = 1; i < scenes.size(); ++i) {
        const Area a = place("picture-of.scene." + scenes[i - 1]);
        const Area b = place("picture-of.scene." + scenes[i]);
        int different = 0;
        for (int y = 0; y < a.height; ++y) {
            for (int x = 0; x < a.width; ++x) {
                const auto at = [&](const Area& area) {
                    return list
                        .pixels[static_cast<std::size_t>((area.y + y) * list.width + area.x + x)];
                };
                different += at(a) != at(b) ? 1 : 0;
            }
        }
        EXPECT_GT(different, a.width * a.height / 4) << scenes[i];
    }
    click("scene.chart");
    click("scene.list");
    EXPECT_TRUE(has("picture-of.scene.night"));
    rest();
    EXPECT_EQ(drawn(), static_cast<int>(scenes.size())) << "drawn anew";
}

TEST_F(WindowStrip, stays_under_what_opens_over_it) {
    start_unsized({"--size", "800x530", "picture.ppm", "--b", "looks/a.cube"});
    first_screen();
    open_strip({"a.cube", "b.json"});
    rest();
    const Screen before = first_screen();
    const Area of_a = place("picture-of.a.cube");
    key("F1");
    const Area help = place("help");
    ASSERT_GT(help.y + help.height, of_a.y + 20) << "the help does not reach the strip";
    const Area both{std::max(of_a.x, help.x) + 2, of_a.y + 2,
                    of_a.x + of_a.width - std::max(of_a.x, help.x) - 4,
                    std::min(of_a.height, help.y + help.height - of_a.y) - 4};
    screen_where([&](const Screen& now) { return now.changed(before, both) > 0.9; }, "the help");
    key("Escape");
    screen_where([&](const Screen& now) { return now.changed(before, of_a) == 0; },
                 "the picture again");
    // Everything on the GPU anew: the pictures come back.
    const int seen = drawn();
    key("ctrl+shift+r");
    wait_drawn(2 * seen);
    screen_where([&](const Screen& now) { return now.changed(before, of_a) == 0; },
                 "the picture on the new device");
}

} // namespace
} // namespace desktop
