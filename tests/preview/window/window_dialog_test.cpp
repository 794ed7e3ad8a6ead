// Files opened and saved through the dialog, by keys and mouse.
#include "tests/preview/window/window_fixture.h"

namespace desktop {
namespace {

namespace fs = std::filesystem;

class WindowDialog : public Window {
  protected:
    bool has(const std::string& place) const { return places().count(place) > 0; }
};

TEST_F(WindowDialog, opens_what_is_found_by_typing_in_a_folder_and_what_was_opened_of_late) {
    fs::create_directory(file("looks"));
    fs::copy_file(file("look.cube"), file("looks/warm.cube"));
    std::ofstream(file("looks/other.txt")) << "x";
    start({"picture.ppm"});
    const Screen before = first_screen();
    key("ctrl+o");
    EXPECT_TRUE(has("file.name"));
    type("looks");
    key("Return"); // goes into the folder
    type("WARM");  // narrows the list to one, which Enter takes
    key("Return");
    const Screen graded = screen_where(
        [&](const Screen& now) { return now.changed(before, between(0.5, 1)) > 0.5; }, "the look");
    EXPECT_FALSE(has("file.name"));
    key("ctrl+z");
    screen_where(is(before), "the picture without it");
    key("ctrl+o");
    click("file.recent.0");
    screen_where(is(graded), "the look of late");
    key("ctrl+o");
    key("Escape");
    EXPECT_FALSE(has("file.name"));
    quit();
    // The next window knows them, and a folder that cannot be read is said.
    start({"picture.ppm"});
    click("tab.Files");
    click("open.choose");
    EXPECT_TRUE(has("file.recent.0"));
    click("file.up");
    click("file.cancel");
    EXPECT_FALSE(has("file.name"));
    screen_where(is(before), "the picture");
}

TEST_F(WindowDialog, puts_a_picture_of_surroundings_about_the_scene) {
    gradient(64, 32).write(file("sky.ppm"));
    std::ofstream(file("no.ppm")) << "x";
    start({"materials"});
    const Screen before = first_screen();
    click("tab.View");
    const auto surround = [&](const std::string& name) {
        scroll_to("surroundings.open");
        click("surroundings.open");
        type(name);
        key("Return");
    };
    surround("sky.ppm");
    screen_where([&](const Screen& now) { return now.changed(before, picture()) > 0.3; },
                 "what surrounds it");
    key("ctrl+z");
    screen_where(is(before), "the scene as it was");
    surround("no.ppm");
    click("error.close");
    screen_where(is(before), "the scene as it was");
}

TEST_F(WindowDialog, saves_under_another_name_and_asks_before_it_writes_over_one) {
    start({"picture.ppm", "--b", "look.cube"});
    first_screen();
    std::ofstream(file("theirs.json")) << "theirs";
    key("ctrl+shift+s");
    key("ctrl+a");
    type("theirs");
    key("Return");
    click("replace.no");
    EXPECT_EQ(contents("theirs.json"), "theirs");
    key("ctrl+s"); // it has no file yet
    EXPECT_TRUE(has("file.name"));
    key("ctrl+a");
    type("mine");
    click("file.choose");
    wait_until([&] { return fs::exists(file("mine.json")); }, "the file");
    key("ctrl+s"); // and now it has
    EXPECT_FALSE(has("file.name"));
    key("ctrl+shift+s");
    key("ctrl+a");
    type("absent/mine");
    key("Return");
    click("error.close");
    EXPECT_FALSE(fs::exists(file("absent")));
}

TEST_F(WindowDialog, saves_the_picture_as_large_as_it_is) {
    start({"picture.ppm", "--b", "look.cube"});
    first_screen();
    click("tab.Files");
    click("save-picture");
    wait_until([&] { return fs::exists(file("look-picture.png")); }, "the picture");
    const std::string png = contents("look-picture.png");
    const auto side = [&](std::size_t at) { // a big-endian number of the chunk IHDR
        return static_cast<unsigned char>(png.at(at + 2)) * 256 +
               static_cast<unsigned char>(png.at(at + 3));
    };
    EXPECT_EQ(side(16), 400);
    EXPECT_EQ(side(20), 480);
    EXPECT_EQ(
        say({LUTPREVIEW, "look-picture.png", "--headless", "-o", "again.png"}, desktop_->folder())
            .code,
        0);
    click("save-picture");
    click("replace.no");
}

} // namespace
} // namespace desktop
