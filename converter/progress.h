// How far a run over many files is.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

namespace converter {

/// "[######------]  12/24 pictures, 8.3/s, 0:02 left".
std::string progress_text(std::size_t done, std::size_t total, std::string_view what,
                          double seconds);

/// From any thread. On a terminal (standard error) a line that is drawn anew; elsewhere nothing.
class Progress {
  public:
    /// `what` are counted: "pictures". `is_quiet` never draws.
    Progress(std::size_t total, std::string_view what, bool is_quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void step();
    /// Prints whole lines, as print() does, beside what is drawn.
    void say(const std::string& lines, const std::string& output);

  private:
    using Clock = std::chrono::steady_clock;

    void draw();
    void wipe();

    std::mutex mutex_;
    std::size_t total_, done_ = 0;
    std::string_view what_;
    bool draws_, is_drawn_ = false;
    Clock::time_point start_ = Clock::now(), drawn_{};
};

} // namespace converter
