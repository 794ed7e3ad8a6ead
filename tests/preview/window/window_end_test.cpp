// How a window ends when nobody closes it: what was not saved is kept, and said where.
#include "tests/preview/window/window_fixture.h"

#include <csignal>

namespace desktop {
namespace {

namespace fs = std::filesystem;

class WindowEnd : public Window {
  protected:
    fs::path settings() const { return file("lutpreview"); }
    std::vector<fs::path> kept() const {
        std::vector<fs::path> out;
        for (const auto& entry : fs::directory_iterator(settings())) {
            if (entry.path().filename().string().starts_with("unsaved-")) {
                out.push_back(entry.path());
            }
        }
        return out;
    }
    /// An operator is added to the look.
    void edit() {
        click("tab.Look");
        click("add");
        click("add.hue-vs-sat");
        click("tab.Files");
    }
    /// What was said is looked at here and not in TearDown.
    std::string take_log() {
        const std::string out = log();
        fs::remove(file("window.txt"));
        return out;
    }
    std::string window_name() const {
        std::string out =
            say({"xdotool", "search", "--name", "lutpreview", "getwindowname"}, desktop_->folder())
                .text;
        out.resize(std::min(out.find('\n'), out.size()));
        return out;
    }
    bool verifies(const fs::path& recipe) const {
        return say({LUTCONV, "bake", recipe, "--allow-outside", "-o", "kept.png"},
                   desktop_->folder())
                   .code == 0;
    }
};

TEST_F(WindowEnd, by_the_display_server_keeps_the_look_and_has_the_code_of_a_machine_that_cannot) {
    start({"picture.ppm", "--b", "look.cube"});
    EXPECT_TRUE(kept().empty()) << "nothing was edited";
    edit();
    desktop_->end_server();
    wait_until([&] { return !program_->is_running(); }, "the end", true);
    EXPECT_EQ(program_->wait(), 2);
    program_.reset();
    ASSERT_EQ(kept().size(), 1U);
    EXPECT_TRUE(verifies(kept()[0]));
    EXPECT_NE(take_log().find("the display server has ended; the unsaved look is in " +
                              kept()[0].string()),
              std::string::npos);
}

TEST_F(WindowEnd, by_a_kill_leaves_a_look_that_the_next_window_tells_of) {
    start({"picture.ppm", "--b", "look.cube"});
    edit();
    wait_until([&] { return kept().size() == 1; }, "the look kept");
    ::kill(program_->id(), SIGKILL);
    program_->wait();
    EXPECT_EQ(take_log(), "");
    start({"picture.ppm"});
    ASSERT_EQ(kept().size(), 1U);
    EXPECT_NE(take_log().find(kept()[0].string()), std::string::npos);
    EXPECT_TRUE(verifies(kept()[0]));
    const fs::path left = kept()[0];
    click("left.0.take");
    EXPECT_EQ(places().count("left.0.take"), 0U) << "it is still offered";
    EXPECT_EQ(window_name(), "* look.cube - lutpreview");
    wait_until([&] { return kept().size() == 1 && kept()[0] != left; }, "the look kept here");
    click("tab.Look");
    click("op0");
    place("op0.curve");
    key("ctrl+s"); // which has no file yet, and so is offered the name of the base
    click("file.choose");
    wait_until([&] { return fs::exists(file("look.json")); }, "the file");
    EXPECT_EQ(window_name(), "look.json - lutpreview");
    EXPECT_TRUE(verifies(file("look.json")));
    wait_until([&] { return kept().empty(); }, "nothing to keep");
}

TEST_F(WindowEnd, by_a_kill_leaves_a_look_that_a_person_may_not_want) {
    fs::create_directories(settings());
    std::ofstream(settings() / "unsaved-999999999.json") << "{";
    start({"picture.ppm"});
    EXPECT_NE(take_log().find("unsaved-999999999.json"), std::string::npos);
    click("left.0.take"); // it cannot be read, and so it stays
    click("error.close");
    EXPECT_EQ(kept().size(), 1U);
    click("left.0.drop");
    EXPECT_TRUE(kept().empty());
    EXPECT_EQ(places().count("left.0.take"), 0U);
}

TEST_F(WindowEnd, by_its_user_is_asked_about_while_there_is_work_that_no_file_has) {
    start({"picture.ppm", "--b", "look.cube"});
    EXPECT_EQ(window_name(), "look.cube - lutpreview");
    edit();
    EXPECT_EQ(window_name(), "* look.cube - lutpreview");
    key("ctrl+q");
    click("close.cancel");
    ASSERT_TRUE(program_->is_running());
    key("ctrl+q");
    place("close.save");
    key("Escape");
    EXPECT_EQ(places().count("close.save"), 0U);
    std::ofstream(file("look.json")) << "somebody's";
    key("ctrl+q");
    click("close.save");
    click("file.choose");
    click("replace.no");
    ASSERT_TRUE(program_->is_running());
    EXPECT_EQ(contents("look.json"), "somebody's");
    key("ctrl+q");
    click("close.save");
    click("file.choose");
    desktop_->xdotool(mouse_to(place("replace.yes").at(0.5, 0.5)) + Words{"click", "1"});
    wait_until([&] { return !program_->is_running(); }, "the end", true);
    EXPECT_EQ(program_->wait(), 0);
    program_.reset();
    EXPECT_TRUE(verifies(file("look.json")));
    EXPECT_TRUE(kept().empty());
}

TEST_F(WindowEnd, by_its_user_is_asked_about_over_a_dialog_too) {
    start({"picture.ppm"});
    edit();
    for (const char* const opens : {"ctrl+o", "ctrl+shift+s", "ctrl+p", "F1"}) {
        key(opens);
        key("ctrl+q");
        click("close.cancel");
        click("tab.View");
        click("tab.Files"); // the mouse is heard
        EXPECT_TRUE(program_->is_running()) << opens;
        key("Escape");
    }
}

TEST_F(WindowEnd, by_its_user_is_asked_about_while_there_are_versions_that_no_file_has) {
    start({"picture.ppm", "--b", "look.cube"});
    key("ctrl+1"); // the look as its file has it
    desktop_->xdotool({"key", "ctrl+q"});
    wait_until([&] { return !program_->is_running(); }, "the end without a question", true);
    start({"picture.ppm", "--b", "look.cube"});
    edit();
    key("ctrl+1");
    click("tab.Look");
    click("op0.remove");
    EXPECT_EQ(window_name(), "look.cube - lutpreview");
    key("ctrl+q");
    place("close.discard");
}

TEST_F(WindowEnd, by_its_user_keeps_nothing) {
    start({"picture.ppm", "--b", "look.cube"});
    edit();
    wait_until([&] { return kept().size() == 1; }, "the look kept");
    key("ctrl+z");
    wait_until([&] { return kept().empty(); }, "nothing to keep after undo");
    edit();
    quit();
    EXPECT_TRUE(kept().empty());
}

TEST_F(WindowEnd, without_a_folder_for_settings_is_as_usual_and_said_before) {
    for (const char* const config : {"", "relative"}) {
        setenv("XDG_CONFIG_HOME", config, 1);
        const std::string home = getenv("HOME") != nullptr ? getenv("HOME") : "";
        unsetenv("HOME");
        start({"picture.ppm"});
        EXPECT_NE(take_log().find("name a folder in XDG_CONFIG_HOME or HOME"), std::string::npos);
        edit();
        quit();
        setenv("HOME", home.c_str(), 1);
        EXPECT_FALSE(fs::exists(file("relative")));
    }
}

} // namespace
} // namespace desktop
