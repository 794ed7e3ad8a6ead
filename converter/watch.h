// --watch: a verb that writes its files again when what they are made of changes.
#pragma once

#include "converter/verb.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace converter {

/// An output and what it is made of.
struct WatchedWork {
    std::vector<std::string> from; ///< files and folders; the bases of recipes are found
    std::string to;
    std::function<int()> run; ///< the answer is an ExitCode; throws Error
};

class WatchOption {
  public:
    void declare(Verb& verb);
    bool given() const { return given_; }

    /// Does all the work that `find` gives for the command line's inputs, `words`, and does again
    /// what has changed; asks `find` again when a folder among them has a new look. Says each of
    /// both in a line on standard error, also what went wrong, which ends nothing. SIGINT and
    /// SIGTERM end the program with exit code 0. Throws UsageError where nothing can be waited for,
    /// where the work would change what it waits for, and where the first run does; Error where
    /// the first `find` does, and where the system watches no more.
    [[noreturn]] void run(std::span<const std::string> words, const std::string& output,
                          const std::function<std::vector<WatchedWork>()>& find) const;

  private:
    bool given_ = false;
};

} // namespace converter
