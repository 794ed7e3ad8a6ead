// A desktop for one test: a virtual X server (Xvfb), a folder, and hands on mouse and keys
// (xdotool). There is no window manager.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace desktop {

/// How long anything may take: software rendering on a machine that does other things too.
inline constexpr std::chrono::seconds patience{150};

/// Whether `holds` becomes true before patience ends.
bool eventually(const std::function<bool()>& holds);

/// A program started in `folder` that ends with the object. What it says goes to `log` there.
class Process {
  public:
    Process(const std::vector<std::string>& words, const std::filesystem::path& folder,
            const std::string& log, std::optional<int> standard_output = {});
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    pid_t id() const { return id_; }
    bool is_running();
    /// Its exit code once it has ended; -1 when a signal ended it.
    int wait();
    /// The processor time that it has taken so far.
    std::chrono::milliseconds processor_time() const;
    /// Whether any of its threads runs, or would if others left it a core.
    bool has_work() const;

  private:
    pid_t id_ = -1;
    bool ended_ = false;
    int status_ = 0;
};

/// What such a program says and its exit code.
struct Said {
    std::string text;
    int code = 0;
};
Said say(const std::vector<std::string>& words, const std::filesystem::path& folder);

struct Point {
    int x = 0, y = 0;
    friend bool operator==(const Point&, const Point&) = default;
};

/// A part of the screen.
struct Area {
    int x = 0, y = 0, width = 0, height = 0;
    /// The point at these shares of the width and height.
    Point at(double across, double down) const {
        return {x + static_cast<int>(across * width), y + static_cast<int>(down * height)};
    }
};

/// Rows of 32-bit pixels; the pointer is in the picture.
struct Screen {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
    friend bool operator==(const Screen&, const Screen&) = default;

    /// The share of the area's pixels that differ.
    double changed(const Screen& other, const Area& area) const;
    /// As a picture in PPM format.
    void write(const std::filesystem::path& path) const;
};

class Desktop {
  public:
    /// What it takes and this machine does not have; empty when all is there.
    static std::string missing();

    /// Throws std::runtime_error.
    Desktop(int width, int height);
    ~Desktop();

    const std::filesystem::path& folder() const { return folder_; }
    /// ":7"; for the environment of programs.
    const std::string& display() const { return display_; }
    /// As when its user logs out, or it crashes.
    void end_server() { server_.reset(); }
    /// Whether the server has yet to do what it was told.
    bool has_work() const { return server_ && server_->has_work(); }
    Screen grab() const;
    /// xdotool's commands, one after another. Throws std::runtime_error.
    void xdotool(std::vector<std::string> words) const;

  private:
    std::filesystem::path folder_;
    std::string display_;
    std::unique_ptr<Process> server_;
};

} // namespace desktop
