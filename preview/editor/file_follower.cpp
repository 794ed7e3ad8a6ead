#include "preview/editor/file_follower.h"

#include "lutlib/error.h"
#include "lutlib/io/reason.h"

#include <algorithm>
#include <iterator>
#include <sys/stat.h>
#include <utility>

namespace preview::editor {

namespace {

bool follow_the_same(const std::vector<FollowedFile>& a, const std::vector<FollowedFile>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const FollowedFile& one, const FollowedFile& other) {
                          return one.key == other.key && one.files == other.files;
                      });
}

bool is_one_of(const std::string& path, const std::vector<std::string>& paths) {
    return std::find(paths.begin(), paths.end(), path) != paths.end();
}

/// Also by a rename, which leaves the time of the last write.
bool has_changed_since(FileFollower::Clock::time_point then, const std::string& path) {
    // The system stamps files by a clock that ticks this seldom at most.
    constexpr std::chrono::milliseconds tick{10};
    struct stat now {};
    if (::stat(path.c_str(), &now) != 0) {
        return true;
    }
    const auto changed =
        std::chrono::seconds(now.st_ctim.tv_sec) + std::chrono::nanoseconds(now.st_ctim.tv_nsec);
    return changed >= then.time_since_epoch() - tick;
}

} // namespace

FileFollower::FileFollower(std::function<void()> on_ready)
    : on_ready_(std::move(on_ready)), thread_([this] { run(); }) {}

FileFollower::~FileFollower() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    watch_.wake();
    thread_.join();
}

void FileFollower::follow(std::vector<FollowedFile> files, Clock::time_point opened) {
    {
        const std::lock_guard lock(mutex_);
        if (follow_the_same(files, asked_)) {
            return;
        }
        asked_ = std::move(files);
        opened_ = opened;
        is_asked_anew_ = true;
    }
    watch_.wake();
}

std::vector<Reread> FileFollower::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(finished_, {});
}

void FileFollower::publish(Reread reread) {
    {
        const std::lock_guard lock(mutex_);
        finished_.push_back(std::move(reread));
    }
    on_ready_();
}

bool FileFollower::is_at_end() {
    const std::lock_guard lock(mutex_);
    return ends_;
}

std::vector<FollowedFile> FileFollower::watch_anew(Clock::time_point opened) {
    std::vector<std::string> paths;
    for (const FollowedFile& file : followed_) {
        for (const std::string& path : file.files) {
            if (lutlib::io::can_be_watched(path)) {
                paths.push_back(path);
            } else {
                publish({file.key, path, {}, "changes are not seen: its folder cannot be listed"});
            }
        }
    }
    watch_.watch(paths);
    std::vector<FollowedFile> due;
    for (const FollowedFile& file : followed_) {
        const auto last = read_at_.try_emplace(file.key, opened).first->second;
        if (std::any_of(file.files.begin(), file.files.end(),
                        [&](const std::string& path) { return has_changed_since(last, path); })) {
            due.push_back(file);
        }
    }
    return due;
}

std::vector<FollowedFile> FileFollower::due_after(const std::vector<std::string>& changed) {
    std::vector<FollowedFile> due;
    std::copy_if(
        followed_.begin(), followed_.end(), std::back_inserter(due), [&](const FollowedFile& file) {
            return std::any_of(file.files.begin(), file.files.end(),
                               [&](const std::string& path) { return is_one_of(path, changed); });
        });
    Clock::time_point opened;
    {
        const std::lock_guard lock(mutex_);
        if (!std::exchange(is_asked_anew_, false)) {
            return due;
        }
        followed_ = asked_;
        opened = opened_;
    }
    return watch_anew(opened);
}

void FileFollower::read(const FollowedFile& file) {
    read_at_[file.key] = Clock::now();
    Reread out{file.key, file.files.front()};
    try {
        out.put = file.read();
    } catch (const std::exception& error) {
        out.reason = lutlib::io::reason_of(error);
    }
    publish(std::move(out));
}

void FileFollower::run() {
    try {
        while (!is_at_end()) {
            for (const FollowedFile& file : due_after(watch_.wait())) {
                if (!is_at_end()) {
                    read(file);
                }
            }
        }
    } catch (const std::exception& error) {
        publish({.key = {}, .reason = lutlib::io::reason_of(error)});
    }
}

} // namespace preview::editor
