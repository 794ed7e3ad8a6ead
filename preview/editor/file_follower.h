// Files that what is shown was made of, read again on a thread of their own when they change.
#pragma once

#include "lutlib/io/look.h"
#include "lutlib/io/watch.h"
#include "preview/editor/model.h"

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace preview::editor {

/// Puts what was read in place, or throws and leaves it. What it returns is a look that unsaved
/// changes keep out, for a person to choose; else null.
using PutInPlace = std::function<std::shared_ptr<const lutlib::io::Look>(History&)>;

struct FollowedFile {
    std::string key;                  ///< what of that which is shown, and of what file
    std::vector<std::string> files;   ///< a change of any counts; the first is what it is called
    std::function<PutInPlace()> read; ///< on any thread; throws lutlib::Error
};

/// A file that was read again.
struct Reread {
    std::string key;    ///< empty: nothing is followed any more
    std::string path{}; ///< what people call it
    PutInPlace put{};   ///< empty: it could not be read
    std::string reason{};
};

class FileFollower {
  public:
    using Clock = std::chrono::system_clock; ///< of the times of files

    /// `on_ready` is called on the reading thread whenever something has been read. Throws
    /// lutlib::Error where the system tells of no changes.
    explicit FileFollower(std::function<void()> on_ready);
    ~FileFollower();
    FileFollower(const FileFollower&) = delete;
    FileFollower& operator=(const FileFollower&) = delete;

    /// Follows these in place of those before. One that has changed since it was read last is read
    /// at once: since `opened`, which is before that, where it has not been followed before.
    void follow(std::vector<FollowedFile> files, Clock::time_point opened);
    /// What has been read since the last call, each once.
    std::vector<Reread> take();

  private:
    void run();
    /// Those to read, once these paths have changed.
    std::vector<FollowedFile> due_after(const std::vector<std::string>& changed);
    /// Watches what was asked for; those that have changed meanwhile.
    std::vector<FollowedFile> watch_anew(Clock::time_point opened);
    void read(const FollowedFile& file);
    void publish(Reread reread);
    bool is_at_end();

    std::function<void()> on_ready_;
    std::mutex mutex_;
    std::vector<FollowedFile> asked_;
    Clock::time_point opened_{};
    bool is_asked_anew_ = false, ends_ = false;
    std::vector<Reread> finished_;
    // The thread's own.
    lutlib::io::FileWatch watch_;
    std::vector<FollowedFile> followed_;
    std::map<std::string, Clock::time_point> read_at_; ///< by key
    std::thread thread_;
};

} // namespace preview::editor
