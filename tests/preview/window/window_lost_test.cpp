// The device is lost under an open window, by a layer that loses it: the window goes on, or ends in
// a sentence, and the look is kept either way.
#include "tests/preview/window/look_window.h"

#include <algorithm>

namespace desktop {
namespace {

namespace fs = std::filesystem;

class WindowLost : public LookWindow {
  protected:
    void SetUp() override {
        LookWindow::SetUp();
        setenv("VK_INSTANCE_LAYERS", "VK_LAYER_TESTS_losing", 1);
        setenv("VK_LAYER_PATH", LUT_LOSING_LAYER ":/usr/share/vulkan/explicit_layer.d", 1);
    }
    void TearDown() override {
        unsetenv("VK_INSTANCE_LAYERS");
        unsetenv("VK_LAYER_PATH");
        unsetenv("LUT_LOSES_DEVICE");
        LookWindow::TearDown();
    }
    /// From the next submission on.
    void lose(const std::string& how) { std::ofstream(file("lost")) << how << std::flush; }
    /// A grey look, of which the key D leaves out the one operator: a change within one frame,
    /// whose submission is the one that loses the device.
    Screen start_losable() {
        setenv("LUT_LOSES_DEVICE", file("lost").c_str(), 1);
        start_with(R"({"op": "saturation", "amount": 0})");
        click("op0");
        const Screen grey = first_screen();
        rest();
        EXPECT_TRUE(kept().empty());
        return grey;
    }
    std::vector<fs::path> kept() const {
        std::vector<fs::path> out;
        for (const auto& entry : fs::directory_iterator(file("lutpreview"))) {
            if (entry.path().filename().string().starts_with("unsaved-")) {
                out.push_back(entry.path());
            }
        }
        return out;
    }
    /// What was said is looked at here and not in TearDown.
    std::string take_log() {
        const std::string out = log();
        fs::remove(file("window.txt"));
        return out;
    }
};

TEST_F(WindowLost, once_is_told_and_the_window_goes_on_with_the_look_and_its_undo) {
    const Screen grey = start_losable();
    lose("once");
    key("d");
    EXPECT_FALSE(fs::exists(file("lost"))) << "nothing was lost";
    EXPECT_EQ(kept().size(), 1U);
    click("error.close");
    screen_where([&](const Screen& now) { return now.changed(grey, between(0.5, 1)) > 0.5; },
                 "colours");
    EXPECT_EQ(saved()["operators"].at(0)["enabled"], false);
    key("ctrl+z");
    screen_where(is(grey), "the look before");
}

TEST_F(WindowLost, again_and_again_ends_in_a_sentence_and_the_next_window_offers_the_look) {
    start_losable();
    lose("always");
    desktop_->xdotool({"key", "d"});
    wait_until([&] { return !program_->is_running(); }, "the end", true);
    EXPECT_EQ(program_->wait(), 2);
    program_.reset();
    const std::string said = take_log();
    ASSERT_EQ(kept().size(), 1U) << said;
    EXPECT_NE(said.find("the GPU was lost twice"), std::string::npos) << said;
    EXPECT_NE(said.find("; the unsaved look is in " + kept()[0].string()), std::string::npos)
        << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    fs::remove(file("lost"));
    start({"picture.ppm"});
    take_log();
    click("left.0.take");
    EXPECT_EQ(places().count("left.0.take"), 0U);
    key("ctrl+shift+s");
    key("ctrl+a");
    type("taken.json");
    click("file.choose");
    wait_until([&] { return fs::exists(file("taken.json")); }, "the file");
    EXPECT_EQ(nlohmann::json::parse(contents("taken.json"))["operators"].at(0)["enabled"], false);
}

} // namespace
} // namespace desktop
