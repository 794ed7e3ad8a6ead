// An open file of the operating system, closed at the end of its life.
#pragma once

#include <unistd.h>
#include <utility>

namespace lutlib::io {

/// The standard streams stay open.
class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() {
        if (fd_ > STDERR_FILENO) {
            ::close(fd_);
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return fd_; }
    /// The caller closes it.
    int release() { return std::exchange(fd_, -1); }

  private:
    int fd_;
};

} // namespace lutlib::io
