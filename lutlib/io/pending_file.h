// A new file beside its target, moved over it when it is whole.
#pragma once

#include "lutlib/io/cleanup.h"
#include "lutlib/io/descriptor.h"

#include <cstdint>
#include <list>
#include <string>

namespace lutlib::io {

/// For who writes to a path himself: he writes to path(), which lies beside the target and has its
/// extension, and commit() moves that file over the target. Without commit() the destructor or a
/// signal removes it; what a process that was killed left is removed by the next one for the same
/// target.
class PendingFile {
  public:
    /// Creates the empty temporary file. `target` must not be `-`. Throws Error.
    explicit PendingFile(const std::string& target);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    const std::string& path() const { return path_; }
    /// Flushes and renames. Throws Error; the old file is then unchanged.
    void commit();

    /// commit() in steps, for several files: all flush(), then all replace(), then all keep(). An
    /// undo() instead of the last brings back what was there.
    void flush() const;
    void replace();
    void undo() noexcept;
    void keep() noexcept;

  private:
    enum class State : std::uint8_t { written, swapped, moved, kept };
    std::string target_; ///< with symbolic links followed
    std::string path_;   ///< the new file; the old one once they are swapped
    Descriptor file_;    ///< locked as long as somebody is at it
    RemovedBySignals removed_;
    State state_ = State::written;
};

/// All of them or none. Throws Error.
void commit_all(std::list<PendingFile>& files);

} // namespace lutlib::io
