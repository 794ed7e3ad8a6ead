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
    EXPECT_NE(take_log().find("open " + kept()[0].string()), std::string::npos);
    EXPECT_TRUE(verifies(kept()[0]));
    first_screen();
    EXPECT_EQ(places().count("error.close"), 1U);
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
