// lutpreview's window on a desktop of its own, and what tests do with it. The program tells where
// its controls are (--places).
#pragma once

#include "tests/preview/window/desktop.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

namespace desktop {

using Words = std::vector<std::string>;

inline constexpr int screen_width = 900, screen_height = 540;
// Columns beside the split line that antialiasing may mix: it follows edges across the line.
inline constexpr int fxaa_reach = 40;
// Rows at the top where the pointer rests.
inline constexpr int pointer_height = 40;

inline Words mouse_to(Point at) {
    return {"mousemove", std::to_string(at.x), std::to_string(at.y)};
}

inline Words operator+(Words a, const Words& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Red to the right, green downwards.
inline Screen gradient(int width, int height) {
    Screen out{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            out.pixels.push_back(static_cast<std::uint32_t>((255 * x / width) << 16 |
                                                            (255 * y / height) << 8 | 128));
        }
    }
    return out;
}

class Window : public ::testing::Test {
  protected:
    void SetUp() override {
        if (const std::string missing = Desktop::missing(); !missing.empty()) {
            GTEST_SKIP() << missing;
        }
        desktop_.emplace(screen_width, screen_height);
        setenv("DISPLAY", desktop_->display().c_str(), 1);
        setenv("XDG_CONFIG_HOME", desktop_->folder().c_str(), 1);
        std::filesystem::copy_file(std::filesystem::path(LUT_LOOKS_FOLDER) / "warm_teal.cube",
                                   file("look.cube"));
        gradient(400, 480).write(file("picture.ppm"));
    }
    void TearDown() override {
        if (!desktop_) {
            return;
        }
        if (HasFailure()) {
            const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
            std::filesystem::create_directories(LUT_FAILED_FOLDER);
            const std::filesystem::path path =
                std::filesystem::path(LUT_FAILED_FOLDER) / (test->name() + std::string(".ppm"));
            desktop_->grab().write(path);
            std::printf("The screen is kept in %s\n", path.c_str());
            return;
        }
        if (program_) {
            quit();
        }
        EXPECT_EQ(log(), "") << "the window said something";
    }

    void start(const Words& arguments = {}) {
        start_unsized(Words{"--size", "800x480"} + arguments);
    }
    /// As people do, who name no size.
    void start_unsized(const Words& arguments = {}) {
        launch(arguments);
        act(mouse_to({100, 100}));
    }
    /// The pointer stays where it is, which may be outside.
    void launch(const Words& arguments = {}) {
        std::filesystem::remove(file("places.txt"));
        program_ = std::make_unique<Process>(
            Words{LUTPREVIEW, "--shadow-size", "256", "--places", "places.txt", "--validate"} +
                arguments,
            desktop_->folder(), "window.txt");
        wait_until([&] { return std::filesystem::exists(file("places.txt")); }, "the first frames");
    }
    /// As a person does, who discards what is not saved: the program writes its layout and frees
    /// what it has.
    void quit() {
        desktop_->xdotool({"key", "ctrl+q"});
        const auto asks = [&] { return places().count("close.discard") > 0; };
        wait_until([&] { return !program_->is_running() || asks(); }, "the end", true);
        if (program_->is_running()) {
            const Point at = place("close.discard").at(0.5, 0.5);
            desktop_->xdotool(mouse_to(at) + Words{"mousedown", "1", "mouseup", "1"});
            wait_until([&] { return !program_->is_running(); }, "the end", true);
        }
        EXPECT_EQ(program_->wait(), 0);
        program_.reset();
    }

    std::filesystem::path file(const std::string& name) const { return desktop_->folder() / name; }
    std::string contents(const std::string& name) const {
        std::stringstream text;
        text << std::ifstream(file(name), std::ios::binary).rdbuf();
        return text.str();
    }
    std::string log() const { return contents("window.txt"); }

    void wait_until(const std::function<bool()>& holds, const std::string& what,
                    bool may_end = false) {
        const auto ended = [&] { return program_ && !may_end && !program_->is_running(); };
        const bool seen = eventually([&] { return holds() || ended(); });
        if (ended()) {
            throw std::runtime_error("the window ended before " + what + ": " + log());
        }
        if (!seen) {
            throw std::runtime_error("waited in vain for " + what + ": " + log());
        }
    }

    std::map<std::string, Area> places() const {
        std::map<std::string, Area> out;
        std::ifstream lines(file("places.txt"));
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::string name;
            Area area;
            if (words >> name >> area.x >> area.y >> area.width >> area.height) {
                out[name] = area;
            }
        }
        return out;
    }
    Area place(const std::string& name) const {
        const auto all = places();
        const auto found = all.find(name);
        if (found == all.end()) {
            throw std::runtime_error("the window has no " + name + " now");
        }
        return found->second;
    }
    /// Wheels up or down until the control is seen whole.
    void scroll_to(const std::string& name) {
        const Area all = place("panels");
        for (int i = 0; i < 40; ++i) {
            const Area at = place(name);
            if (at.y > 120 && at.y + at.height < all.height) {
                return;
            }
            act(mouse_to(all.at(0.96, 0.9)) + Words{"click", at.y > 120 ? "5" : "4"});
        }
        throw std::runtime_error(name + " cannot be scrolled to");
    }
    int frame() const { return place("frame").x; }

    /// xdotool's commands, then the pointer away; returns when all that they led to is drawn.
    void act(const Words& words) {
        rest_ = rest_ == rests_[0] ? rests_[1] : rests_[0];
        desktop_->xdotool(words); // apart: `type` takes all words that follow
        desktop_->xdotool(mouse_to(rest_));
        wait_until(
            [&] {
                const auto all = places();
                const auto mouse = all.find("mouse");
                return mouse != all.end() && Point{mouse->second.x, mouse->second.y} == rest_;
            },
            "frames after " + words.at(0));
    }
    void click(Point at) { act(mouse_to(at) + Words{"mousedown", "1", "mouseup", "1"}); }
    void click(const std::string& name) { click(place(name).at(0.5, 0.5)); }
    void drag(Point from, Point over, Point to) {
        act(mouse_to(from) + Words{"mousedown", "1"} + mouse_to(over) + mouse_to(to) +
            Words{"mouseup", "1"});
    }
    void key(const std::string& name) { act({"key", name}); }
    void type(const std::string& text) { act({"type", text}); }
    void open(const std::string& name) {
        click("tab.Files");
        click("open.path");
        key("ctrl+a");
        type(name);
        click("open");
    }

    /// The screen, once it stands still and `holds`.
    Screen screen_where(const std::function<bool(const Screen&)>& holds, const std::string& what) {
        Screen now;
        wait_until(
            [&] {
                const Screen before = desktop_->grab();
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
                now = desktop_->grab();
                return now == before && holds(now);
            },
            what);
        return now;
    }
    Screen first_screen() {
        return screen_where(
            [&](const Screen& now) { return now.changed(black(), picture()) > 0.9; }, "a picture");
    }
    /// The desktop without a window.
    static Screen black() {
        return {screen_width, screen_height,
                std::vector<std::uint32_t>(std::size_t{screen_width} * screen_height)};
    }

    std::function<bool(const Screen&)> is(const Screen& then) const {
        return [this, &then](const Screen& now) { return now.changed(then, picture()) == 0; };
    }
    /// Waits until the program does nothing for a while.
    void rest() {
        constexpr std::chrono::milliseconds step{50}, allowed{10};
        wait_until(
            [&] {
                const int first = frame();
                const auto start = program_->processor_time();
                // Who gets no core of a busy machine takes no time either.
                for (int i = 0; i < 10; ++i) {
                    if (program_->has_work() || desktop_->has_work()) {
                        return false;
                    }
                    std::this_thread::sleep_for(step);
                }
                return program_->processor_time() - start <= allowed && frame() == first;
            },
            "rest");
    }

    /// Where the picture is compared.
    Area picture() const {
        const Area all = place("picture");
        return {all.x, all.y + pointer_height, all.width, all.height - pointer_height};
    }
    /// Its part between these shares of the width, out of antialiasing's reach of both.
    Area between(double left, double right) const {
        const Area all = picture();
        const int from = left > 0 ? static_cast<int>(left * all.width) + fxaa_reach : 0;
        const int to = static_cast<int>(right * all.width) - (right < 1 ? fxaa_reach : 0);
        return {all.x + from, all.y, to - from, all.height};
    }
    /// The window moved to this place and made this large.
    void move_to(const Area& area) {
        desktop_->xdotool({"search", "--name", "lutpreview", "windowmove", std::to_string(area.x),
                           std::to_string(area.y), "windowsize", std::to_string(area.width),
                           std::to_string(area.height)});
        wait_until([&] { return is_as_large(area.width, area.height); }, "the window's new size");
    }
    bool is_as_large(int width, int height) const {
        const Area panels = place("panels");
        return panels.x + panels.width == width && panels.height == height;
    }
    /// Waits for what would be written; then writes it.
    void begin_export(const std::string& button) {
        click(button);
        wait_until([&] { return places().count("export.write") > 0; }, "what would be written");
    }
    void export_by(const std::string& button) {
        begin_export(button);
        click("export.write");
    }
    int verify(const std::string& strip, const std::string& against) const {
        return say({LUTCONV, "verify", strip, "--against", against}, desktop_->folder()).code;
    }

    std::optional<Desktop> desktop_;
    std::unique_ptr<Process> program_;                // ends before its server
    Point rest_;                                      // where the pointer is left
    std::array<Point, 2> rests_{Point{4, 4}, {8, 4}}; // in turn, for a move to be seen
};

} // namespace desktop
