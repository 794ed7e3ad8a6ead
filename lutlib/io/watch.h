// Waiting for files to change, for who works on them anew.
#pragma once

#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lutlib::io {

/// Whether the folder of a file, there or not, is one that FileWatch takes: one that may be listed.
bool can_be_watched(const std::string& path);

/// Tells which files have changed: written and closed, renamed into place, linked or removed. Their
/// folders are watched, so that a file need not be there, and one that an editor renames over
/// another is seen; so is what symbolic links lead to. Not told: a file that its writer keeps open,
/// and what another machine does on a network file system.
class FileWatch {
  public:
    /// What changes again within this time is told once, when it rests, at the latest after `most`.
    static constexpr std::chrono::milliseconds rest{100}, most{1000};

    /// Throws Error where the system gives no watch.
    FileWatch();
    FileWatch(FileWatch&&) noexcept;
    FileWatch& operator=(FileWatch&&) noexcept;
    ~FileWatch();

    /// Watches these in place of those before; of a folder all its files but hidden ones and those
    /// of folders in it. What has happened to a path that is watched still is kept. Throws Error
    /// for a folder that cannot be watched.
    void watch(std::span<const std::string> paths);

    /// Blocks until something has changed or wake() was called, and tells it by the paths that were
    /// given, each once; a folder's file as the folder with its name, and the folder itself where
    /// it is not known what of it has changed. Throws Error.
    std::vector<std::string> wait();
    /// The same without blocking: nothing as long as nothing has changed, or changes still.
    std::vector<std::string> changed();
    /// Ends a wait() at once, this one or else the next; from any thread.
    void wake() const;

  private:
    class Inotify;
    std::unique_ptr<Inotify> inotify_;
};

} // namespace lutlib::io
