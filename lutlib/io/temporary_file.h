// Bytes as a file with a chosen name, for libraries that read only from a path.
#pragma once

#include "lutlib/io/cleanup.h"

#include <string>
#include <string_view>

namespace lutlib::io {

/// Lies in a folder of its own; both are removed with the object, or by a signal.
class TemporaryFile {
  public:
    /// `name` lends the file its own: without its folder, its extension replaced by `extension`
    /// where that is given, and without what libraries expand in paths. Throws Error when it cannot
    /// be written.
    TemporaryFile(std::string_view bytes, const std::string& name, const std::string& extension);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::string& path() const { return path_; }

  private:
    std::string folder_, path_;
    RemovedBySignals folder_removed_, file_removed_;
};

} // namespace lutlib::io
