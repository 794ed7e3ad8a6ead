#include "converter/progress.h"

#include "converter/report.h"

#include <fmt/core.h>

#include <cstdio>
#include <unistd.h>

namespace converter {

std::string progress_text(std::size_t done, std::size_t total, std::string_view what,
                          double seconds) {
    constexpr std::size_t width = 24;
    const std::size_t filled = total > 0 ? width * done / total : width;
    std::string out = fmt::format("[{}{}] {}/{} {}", std::string(filled, '#'),
                                  std::string(width - filled, '-'), done, total, what);
    if (done > 0 && seconds > 0) {
        const double rate = static_cast<double>(done) / seconds;
        const auto left = static_cast<long>(static_cast<double>(total - done) / rate + 0.5);
        out += left < 3600 ? fmt::format(", {:.3g}/s, {}:{:02} left", rate, left / 60, left % 60)
                           : fmt::format(", {:.3g}/s, {}:{:02}:{:02} left", rate, left / 3600,
                                         left / 60 % 60, left % 60);
    }
    return out;
}

Progress::Progress(std::size_t total, std::string_view what, bool is_quiet)
    : total_(total), what_(what), draws_(!is_quiet && ::isatty(STDERR_FILENO) != 0) {
    draw();
}

Progress::~Progress() {
    wipe();
}

void Progress::step() {
    constexpr auto between = std::chrono::milliseconds(100);
    const std::lock_guard lock(mutex_);
    ++done_;
    if (Clock::now() - drawn_ >= between || done_ == total_) {
        draw();
    }
}

void Progress::say(const std::string& lines, const std::string& output) {
    const std::lock_guard lock(mutex_);
    wipe();
    print(lines, output);
    draw();
}

void Progress::draw() {
    if (draws_) {
        drawn_ = Clock::now();
        const double seconds = std::chrono::duration<double>(drawn_ - start_).count();
        wipe();
        std::fputs(progress_text(done_, total_, what_, seconds).c_str(), stderr);
        is_drawn_ = true;
    }
}

void Progress::wipe() {
    if (is_drawn_) {
        std::fputs("\r\x1b[K", stderr);
        is_drawn_ = false;
    }
}

} // namespace converter
