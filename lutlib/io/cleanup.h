// Files that must not outlive the program, also when a signal ends it.
#pragma once

#include <string>

namespace lutlib::io {

/// While it lives, a signal that ends the program (from the keyboard, kill, a closed terminal, a
/// limit) removes the file or the empty folder at `path`. What else handles the signal then still
/// does. Nothing helps against SIGKILL.
class RemovedBySignals {
  public:
    explicit RemovedBySignals(const std::string& path);
    ~RemovedBySignals();
    RemovedBySignals(const RemovedBySignals&) = delete;
    RemovedBySignals& operator=(const RemovedBySignals&) = delete;

  private:
    int slot_;
};

/// While it lives, SIGINT and SIGTERM are how a person ends the program as he means to: with exit
/// code 0, at once, in whatever it is, without the files of RemovedBySignals. Where they were
/// ignored they still are. One at a time.
class EndedBySignals {
  public:
    EndedBySignals();
    ~EndedBySignals();
    EndedBySignals(const EndedBySignals&) = delete;
    EndedBySignals& operator=(const EndedBySignals&) = delete;
};

} // namespace lutlib::io
