// Files as they are now, for processes that may open none.
#pragma once

#include "lutlib/io/descriptor.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <sys/stat.h>
#include <vector>

namespace lutlib::io::box {

struct FileCopy {
    std::shared_ptr<const Descriptor> memory;
    struct stat original {};

    std::size_t size() const { return static_cast<std::size_t>(original.st_size); }
};

/// Any threads may ask at once.
class FileCopies {
  public:
    /// `file` names the file in errors. Throws Error where it cannot be read.
    FileCopy keep(const std::string& path, const std::string& file) const;
    /// The one kept, if the file is still the same; it is kept no longer.
    FileCopy take(const std::string& path, const std::string& file) const;

  private:
    mutable std::mutex mutex_;
    mutable std::vector<FileCopy> kept_; ///< the oldest first
    mutable std::size_t size_ = 0;       ///< of all kept, in bytes
};

/// All of an open file behind another's place, within the system. Throws Error, of `failure`.
void copy_all(int to, int from, const char* failure, const std::string& file);

} // namespace lutlib::io::box
