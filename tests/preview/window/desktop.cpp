#include "tests/preview/window/desktop.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace desktop {

namespace fs = std::filesystem;

namespace {

std::string contents(const fs::path& path) {
    std::stringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
}

bool is_in_path(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access((fs::path(folder) / program).c_str(), X_OK) == 0) {
            return true;
        }
    }
    return false;
}

} // namespace

bool eventually(const std::function<bool()>& holds) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (!holds()) {
        if (std::chrono::steady_clock::now() > end) {
            return false;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
}

Process::Process(const std::vector<std::string>& words, const fs::path& folder,
                 const std::string& log, std::optional<int> standard_output) {
    std::vector<char*> arguments;
    for (const std::string& word : words) {
        arguments.push_back(const_cast<char*>(word.c_str()));
    }
    arguments.push_back(nullptr);
    id_ = fork();
    if (id_ != 0) {
        return;
    }
    prctl(PR_SET_PDEATHSIG, SIGKILL); // nothing outlives a test that was ended
    if (chdir(folder.c_str()) != 0) {
        _exit(126);
    }
    const int said = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    dup2(said, STDERR_FILENO);
    dup2(standard_output.value_or(said), STDOUT_FILENO);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

Process::~Process() {
    if (is_running()) {
        kill(id_, SIGTERM);
    }
    wait();
}

bool Process::is_running() {
    if (!ended_ && waitpid(id_, &status_, WNOHANG) == id_) {
        ended_ = true;
    }
    return !ended_;
}

int Process::wait() {
    if (!ended_) {
        waitpid(id_, &status_, 0);
    }
    ended_ = true;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}

std::chrono::milliseconds Process::processor_time() const {
    // proc(5): after the name in parentheses, which may hold anything, utime and stime are the
    // 12th and 13th words.
    const std::string stat = contents("/proc/" + std::to_string(id_) + "/stat");
    std::istringstream words(stat.substr(stat.rfind(')') + 1));
    std::string skipped;
    for (int i = 0; i < 11; ++i) {
        words >> skipped;
    }
    long user = 0, system = 0;
    words >> user >> system;
    return std::chrono::milliseconds((user + system) * 1000 / sysconf(_SC_CLK_TCK));
}

bool Process::has_work() const {
    std::error_code gone; // threads end while they are looked at
    const fs::path threads = "/proc/" + std::to_string(id_) + "/task";
    for (fs::directory_iterator it(threads, gone), end; !gone && it != end; it.increment(gone)) {
        const std::string stat = contents(it->path() / "stat");
        const std::size_t name = stat.rfind(')');
        if (name != std::string::npos && name + 2 < stat.size() &&
            (stat[name + 2] == 'R' || stat[name + 2] == 'D')) {
            return true;
        }
    }
    return false;
}

Said say(const std::vector<std::string>& words, const fs::path& folder) {
    const std::string log = "said.txt";
    fs::remove(folder / log);
    const int code = Process(words, folder, log).wait();
    return {contents(folder / log), code};
}

double Screen::changed(const Screen& other, const Area& area) const {
    if (other.width != width || other.height != height || area.x < 0 || area.y < 0 ||
        area.width <= 0 || area.height <= 0 || area.x + area.width > width ||
        area.y + area.height > height) {
        throw std::runtime_error("this area is not on both screens");
    }
    std::size_t count = 0;
    for (int y = area.y; y < area.y + area.height; ++y) {
        for (int x = area.x; x < area.x + area.width; ++x) {
            const auto at = static_cast<std::size_t>(y * width + x);
            count += pixels[at] != other.pixels[at] ? 1 : 0;
        }
    }
    return static_cast<double>(count) / area.width / area.height;
}

void Screen::write(const fs::path& path) const {
    std::ofstream out(path, std::ios::binary);
    out << "P6 " << width << ' ' << height << " 255\n";
    for (const std::uint32_t pixel : pixels) {
        for (const unsigned shift : {16U, 8U, 0U}) {
            out.put(static_cast<char>(pixel >> shift & 0xffU));
        }
    }
}

std::string Desktop::missing() {
    for (const char* program : {"Xvfb", "xdotool"}) {
        if (!is_in_path(program)) {
            return std::string(program) + " is missing (scripts/setup installs it)";
        }
    }
    return {};
}

Desktop::Desktop(int width, int height) {
    std::string name = (fs::temp_directory_path() / "lutpreview_desktop_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        throw std::runtime_error("no folder can be made in " + name);
    }
    folder_ = name;
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) {
        throw std::runtime_error("no pipe can be made");
    }
    // -r: a key held for long on a busy machine does not repeat. -noreset: what programs have set
    // outlives them, as on a person's desktop.
    server_ = std::make_unique<Process>(
        std::vector<std::string>{"Xvfb", "-displayfd", "1", "-screen", "0",
                                 std::to_string(width) + "x" + std::to_string(height) + "x24",
                                 "-fbdir", folder_.string(), "-nolisten", "tcp", "-r", "-noreset"},
        folder_, "server.txt", ends[1]);
    close(ends[1]);
    std::string number;
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) {
        number += c;
    }
    close(ends[0]);
    if (number.empty()) {
        throw std::runtime_error("Xvfb did not start: " + contents(folder_ / "server.txt"));
    }
    display_ = ":" + number;
}

Desktop::~Desktop() {
    server_.reset();
    std::error_code kept;
    fs::remove_all(folder_, kept);
}

Screen Desktop::grab() const {
    // XWDFileHeader of X11/XWDFile.h, words of 32 bits, big-endian: 0 header_size, 4 width,
    // 5 height, 12 bytes_per_line, 19 ncolors; then the colours of 12 bytes each, then the rows.
    const std::string bytes = contents(folder_ / "Xvfb_screen0");
    const auto word = [&](std::size_t index) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            value = value << 8U | static_cast<std::uint8_t>(bytes.at(4 * index + i));
        }
        return value;
    };
    Screen out;
    out.width = static_cast<int>(word(4));
    out.height = static_cast<int>(word(5));
    out.pixels.resize(std::size_t{word(4)} * word(5));
    const std::size_t start = word(0) + std::size_t{12} * word(19);
    if (bytes.size() < start + std::size_t{word(5)} * word(12)) {
        throw std::runtime_error("the screen's file is too short");
    }
    for (std::size_t y = 0; y < word(5); ++y) {
        std::memcpy(out.pixels.data() + y * word(4), bytes.data() + start + y * word(12),
                    std::size_t{4} * word(4));
    }
    for (std::uint32_t& pixel : out.pixels) {
        pixel &= 0xffffffU;
    }
    return out;
}

void Desktop::xdotool(std::vector<std::string> words) const {
    words.insert(words.begin(), "xdotool");
    const Said said = say(words, folder_);
    if (said.code != 0) {
        throw std::runtime_error("xdotool " + words.at(1) + ": " + said.text);
    }
}

} // namespace desktop
