// The window as a person uses it: real mouse and key events from xdotool on a virtual X server.
//
// The server keeps its screen in a file in XWD format, which this test looks at. The program tells
// where its controls are (--places).
#include <gtest/gtest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto patience = 60s; // software rendering on a machine that does other things too
// Columns beside the split line that antialiasing may mix: it follows edges across the line.
constexpr std::size_t fxaa_reach = 40;

/// Ends with the object.
class Process {
  public:
    Process(const std::vector<std::string>& words, const fs::path& folder, int inherited = -1) {
        id_ = fork();
        if (id_ != 0)
            return;
        if (chdir(folder.c_str()) != 0)
            _exit(126);
        const int log = open("log.txt", O_WRONLY | O_CREAT | O_APPEND, 0600);
        dup2(log, STDERR_FILENO);
        dup2(inherited >= 0 ? inherited : log, STDOUT_FILENO);
        std::vector<char*> arguments;
        for (const std::string& word : words)
            arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    ~Process() {
        if (is_running())
            kill(id_, SIGTERM);
        wait();
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    bool is_running() {
        if (!ended_ && waitpid(id_, &status_, WNOHANG) == id_)
            ended_ = true;
        return !ended_;
    }
    int wait() {
        if (!ended_)
            waitpid(id_, &status_, 0);
        ended_ = true;
        return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
    }

  private:
    pid_t id_ = -1;
    bool ended_ = false;
    int status_ = 0;
};

struct Place {
    int x = 0, y = 0, width = 0, height = 0;
    /// A point at these shares of the width and height.
    std::pair<int, int> at(double across, double down) const {
        return {x + static_cast<int>(across * width), y + static_cast<int>(down * height)};
    }
};

/// Rows of 32-bit pixels.
struct Screen {
    std::size_t width = 0, height = 0;
    std::vector<std::uint32_t> pixels;

    /// The share of pixels that differ between columns `left` and `right`.
    double changed(const Screen& other, std::size_t left, std::size_t right) const {
        std::size_t count = 0;
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = left; x < right; ++x)
                count += pixels[y * width + x] != other.pixels[y * width + x] ? 1 : 0;
        return static_cast<double>(count) / static_cast<double>(height * (right - left));
    }
};

class Window : public ::testing::Test {
  protected:
    void SetUp() override {
        char name[] = "/tmp/lutpreview_window_XXXXXX";
        folder_ = mkdtemp(name);
        int ends[2];
        ASSERT_EQ(pipe(ends), 0);
        server_ = std::make_unique<Process>(
            std::vector<std::string>{"Xvfb", "-displayfd", "1", "-screen", "0", "1280x720x24",
                                     "-fbdir", folder_.string(), "-nolisten", "tcp"},
            folder_, ends[1]);
        close(ends[1]);
        std::string number;
        for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';)
            number += c;
        close(ends[0]);
        ASSERT_FALSE(number.empty()) << "Xvfb did not start: " << log();
        setenv("DISPLAY", (":" + number).c_str(), 1);
        setenv("XDG_CONFIG_HOME", folder_.c_str(), 1);
        fs::copy_file(fs::path(LUT_LOOKS_FOLDER) / "warm_teal.cube", folder_ / "look.cube");
    }
    void TearDown() override {
        program_.reset();
        server_.reset();
        if (HasFailure())
            std::fputs(log().c_str(), stderr);
        fs::remove_all(folder_);
    }

    void start(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), LUTPREVIEW);
        for (const char* word : {"--size", "1280x720", "--places", "places.txt", "--validate"})
            arguments.emplace_back(word);
        program_ = std::make_unique<Process>(arguments, folder_);
        place("tab.Look");
        settle(0);
    }

    std::string log() const {
        std::stringstream text;
        text << std::ifstream(folder_ / "log.txt").rdbuf();
        return text.str();
    }

    bool eventually(const std::function<bool()>& holds) {
        const auto end = std::chrono::steady_clock::now() + patience;
        while (!holds()) {
            if (std::chrono::steady_clock::now() > end || (program_ && !program_->is_running()))
                return false;
            std::this_thread::sleep_for(50ms);
        }
        return true;
    }

    std::map<std::string, Place> places() const {
        std::map<std::string, Place> out;
        std::ifstream file(folder_ / "places.txt");
        std::string name;
        Place place;
        for (std::string line; std::getline(file, line);) {
            std::istringstream words(line);
            if (words >> name >> place.x >> place.y >> place.width >> place.height)
                out[name] = place;
        }
        return out;
    }
    /// Waits for the control to be there.
    Place place(const std::string& name) {
        EXPECT_TRUE(eventually([&] { return places().count(name) == 1; })) << name;
        return places()[name];
    }

    /// The number of the last frame that was drawn.
    int frame() const {
        const auto all = places();
        const auto found = all.find("frame");
        return found == all.end() ? 0 : found->second.x;
    }
    /// Waits until nothing is left to draw after frame `before`, and nothing follows.
    void settle(int before) {
        eventually([&] { return frame() > before; });
        for (int last = -1, now = frame(); now != last; now = frame()) {
            last = now;
            std::this_thread::sleep_for(200ms);
        }
    }
    /// An event, and the frames that it leads to: a hand is slower than they are too.
    void xdotool(std::vector<std::string> words) {
        const int before = frame();
        words.insert(words.begin(), "xdotool");
        EXPECT_EQ(Process(words, folder_).wait(), 0) << words[1];
        settle(before);
    }
    void move_to(std::pair<int, int> at) {
        xdotool({"mousemove", std::to_string(at.first), std::to_string(at.second)});
    }
    void press(std::pair<int, int> at) {
        move_to(at);
        xdotool({"mousedown", "1"});
    }
    void release() { xdotool({"mouseup", "1"}); }
    void click(const std::string& name) {
        press(place(name).at(0.5, 0.5));
        release();
    }
    void key(const std::string& name) { xdotool({"key", name}); }

    /// The screen once it stands still, the mouse out of the way.
    Screen screen() {
        move_to({1200 + parked_, 600});
        parked_ = 1 - parked_; // a move to the same place is no event
        return grab();
    }

    int verify(const std::string& strip) {
        return Process({LUTCONV, "verify", strip, "--against", "look.cube"}, folder_).wait();
    }

    std::size_t picture_width() { return static_cast<std::size_t>(place("picture").width); }

    Screen grab() const {
        std::ifstream file(folder_ / "Xvfb_screen0", std::ios::binary);
        std::stringstream all;
        all << file.rdbuf();
        const std::string bytes = all.str();
        const auto word = [&](std::size_t index) {
            std::uint32_t value = 0;
            for (std::size_t i = 0; i < 4; ++i)
                value = value << 8U | static_cast<std::uint8_t>(bytes[4 * index + i]);
            return value;
        };
        // XWDFileHeader: 0 header_size, 4 width, 5 height, 12 bytes_per_line, 19 ncolors.
        Screen out;
        out.width = word(4);
        out.height = word(5);
        const std::size_t start = word(0) + std::size_t{12} * word(19);
        for (std::size_t y = 0; y < out.height; ++y)
            for (std::size_t x = 0; x < out.width; ++x) {
                std::uint32_t pixel = 0;
                std::memcpy(&pixel, bytes.data() + start + y * word(12) + 4 * x, 4);
                out.pixels.push_back(pixel & 0xffffffU);
            }
        return out;
    }

    fs::path folder_;
    int parked_ = 0;
    std::unique_ptr<Process> server_, program_;
};

TEST_F(Window, opens_a_look_edits_a_curve_moves_the_split_undoes_and_exports_a_right_strip) {
    start({});
    click("tab.Files");
    const Screen without_look = screen();
    click("open.path");
    xdotool({"type", "look.cube"});
    click("open");
    const Screen opened = screen();
    const std::size_t width = picture_width();
    EXPECT_GT(opened.changed(without_look, width / 2 + fxaa_reach, width), 0.5)
        << "the look is not seen";
    EXPECT_EQ(opened.changed(without_look, 0, width / 2 - fxaa_reach), 0) << "side A shows it too";

    click("export-strip");
    ASSERT_TRUE(eventually([&] { return fs::exists(folder_ / "look-piccolo.png"); }));
    EXPECT_EQ(verify("look-piccolo.png"), 0);

    click("tab.Look");
    click("add");
    click("add.hue-vs-sat");
    const Place curve = place("op0.curve");
    const Screen neutral = screen();
    EXPECT_EQ(neutral.changed(opened, 0, width), 0) << "a neutral operator changes the picture";

    press(curve.at(0.1, 0.5));
    move_to(curve.at(0.1, 0.7));
    move_to(curve.at(0.1, 0.95));
    release();
    const Screen edited = screen();
    EXPECT_GT(edited.changed(neutral, width / 2 + fxaa_reach, width), 0.01)
        << "the knot does nothing";
    EXPECT_EQ(edited.changed(neutral, 0, width / 2 - fxaa_reach), 0);

    const Place picture = place("picture");
    press(picture.at(0.5, 0.3));
    move_to(picture.at(0.4, 0.3));
    move_to(picture.at(0.25, 0.3));
    release();
    const Screen moved = screen();
    EXPECT_GT(moved.changed(edited, width / 4 + fxaa_reach, width / 2 - fxaa_reach), 0.5);
    EXPECT_EQ(moved.changed(edited, 0, width / 4 - fxaa_reach), 0);
    EXPECT_EQ(moved.changed(edited, width / 2 + fxaa_reach, width), 0);

    key("ctrl+z");
    EXPECT_EQ(screen().changed(edited, 0, width), 0) << "the split is not where it was";
    key("ctrl+z");
    EXPECT_EQ(screen().changed(neutral, 0, width), 0) << "the knot is still there";
    key("ctrl+y");
    EXPECT_EQ(screen().changed(edited, 0, width), 0);

    // The edited look is not the file's, and its strip says so; the old strip is asked about.
    click("tab.Files");
    click("export-strip");
    click("replace.no");
    EXPECT_EQ(verify("look-piccolo.png"), 0);
    click("export-strip");
    click("replace.yes");
    ASSERT_TRUE(eventually([&] { return verify("look-piccolo.png") != 0; }));
    EXPECT_EQ(log().find("VUID"), std::string::npos);
}

} // namespace
