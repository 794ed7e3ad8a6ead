// PNG files one behind the other, as ffmpeg's image2pipe writes and reads them.
#pragma once

#include "lutlib/byte_source.h"

#include <cstddef>
#include <optional>
#include <string>

namespace lutlib::io {

/// Takes whole files off a source, and nothing beyond what it gives.
class PngStream {
  public:
    /// `name` is what messages call the source. Both outlive it.
    PngStream(ByteSource& source, const std::string& name) : source_(source), name_(name) {}

    /// The next file, by its chunks' lengths alone; nothing at the end. Throws Error for what is no
    /// PNG, is cut short, or is longer than limits.h allows.
    std::optional<std::string> next();

  private:
    bool append(std::string& to, std::size_t bytes);

    ByteSource& source_;
    const std::string& name_;
    std::size_t count_ = 0;
};

} // namespace lutlib::io
