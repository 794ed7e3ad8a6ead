// What goes wrong around a window: it says so in a sentence, goes on, and loses nothing.
#include "tests/preview/window/window_fixture.h"

#include <csignal>

namespace desktop {
namespace {

namespace fs = std::filesystem;

class WindowTrouble : public Window {
  protected:
    fs::path settings() const { return file("lutpreview"); }
    fs::path kept_by(pid_t process) const {
        return settings() / ("unsaved-" + std::to_string(process) + ".json");
    }
    /// An operator is added to the look.
    void edit() {
        click("tab.Look");
        click("add");
        click("add.hue-vs-sat");
    }
    /// What was said is looked at here and not in TearDown.
    std::string take_log() {
        const std::string out = log();
        fs::remove(file("window.txt"));
        return out;
    }
};

TEST_F(WindowTrouble, two_windows_at_once_keep_each_their_own_look) {
    start({"picture.ppm", "--b", "look.cube"});
    edit();
    const pid_t first = program_->id();
    wait_until([&] { return fs::exists(kept_by(first)); }, "the first window's look kept");
    const std::string of_first = contents("lutpreview/" + kept_by(first).filename().string());
    std::unique_ptr<Process> other = std::move(program_);
    start({"picture.ppm", "--b", "look.cube"});
    EXPECT_EQ(places().count("left.0.take"), 0U) << "a window that runs left nothing";
    edit();
    const pid_t second = program_->id();
    wait_until([&] { return fs::exists(kept_by(second)); }, "the second window's look kept");
    ::kill(second, SIGKILL);
    program_->wait();
    program_.reset();
    EXPECT_TRUE(fs::exists(kept_by(second)));
    EXPECT_EQ(contents("lutpreview/" + kept_by(first).filename().string()), of_first);
    ::kill(other->id(), SIGKILL);
    other->wait();
    start({"picture.ppm"});
    EXPECT_EQ(places().count("left.1.take"), 1U) << "both are offered";
    EXPECT_NE(take_log().find(kept_by(second).string()), std::string::npos);
    click("left.0.drop");
    click("left.0.take");
    EXPECT_EQ(places().count("left.0.take"), 0U);
    key("ctrl+z"); // taking it up is a step
}

TEST_F(WindowTrouble, a_settings_folder_that_cannot_be_is_said_and_the_rest_goes_on) {
    std::ofstream(file("file")) << "no folder";
    setenv("XDG_CONFIG_HOME", file("file").c_str(), 1);
    start({"picture.ppm", "--b", "look.cube"});
    EXPECT_NE(take_log().find("name a folder in XDG_CONFIG_HOME or HOME"), std::string::npos);
    edit();
    key("ctrl+shift+s");
    click("file.choose");
    wait_until([&] { return fs::exists(file("look.json")); }, "the file");
}

TEST_F(WindowTrouble, a_look_that_cannot_be_kept_is_said_once_and_can_be_saved) {
    start({"picture.ppm", "--b", "look.cube"});
    fs::create_directories(kept_by(program_->id()) / "in the way");
    edit();
    wait_until([&] { return places().count("error.close") > 0; }, "the reason");
    EXPECT_NE(take_log().find("save the look"), std::string::npos);
    click("error.close");
    EXPECT_EQ(places().count("error.close"), 0U);
    key("ctrl+shift+s");
    click("file.choose");
    wait_until([&] { return fs::exists(file("look.json")); }, "the file");
}

TEST_F(WindowTrouble, settings_that_are_broken_are_said_and_replaced) {
    fs::create_directories(settings());
    std::ofstream(settings() / "window.json") << R"({"recent files": 5, "area": [)";
    std::ofstream(settings() / "layout.ini") << "[Window][\xff\nPos=x,y\n[";
    start({"picture.ppm"});
    click("error.close");
    click("tab.Look");
    quit();
    start({"picture.ppm"});
    EXPECT_EQ(places().count("error.close"), 0U) << contents("lutpreview/window.json");
    EXPECT_EQ(contents("lutpreview/window.json.broken"), R"({"recent files": 5, "area": [)");
}

TEST_F(WindowTrouble, what_is_shown_outlives_its_files_and_the_gpu) {
    fs::copy_file(file("picture.ppm"), file("soon gone.ppm"));
    start({"soon gone.ppm", "--b", "look.cube"});
    const Screen before = first_screen();
    fs::remove(file("soon gone.ppm"));
    fs::remove(file("look.cube"));
    wait_until([&] { return places().count("notice.1") > 0; }, "both reasons");
    key("ctrl+shift+r");
    screen_where(is(before), "the same picture");
    click("tab.Files");
    export_by("export-strip");
    EXPECT_TRUE(fs::exists(file("look-piccolo.png")));
}

} // namespace
} // namespace desktop
